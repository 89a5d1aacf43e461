# edvo_module(USES folder... PUBLIC target... PRIVATE target...) makes a static library of the folder
# that it is called in: of all its source files, named after its path (vo/core is vo_core). USES names
# the folders whose headers it may include, which tools/check_layers.py holds it to; PUBLIC and PRIVATE
# are targets of other projects.
function(edvo_module)
  cmake_parse_arguments(PARSE_ARGV 0 module "" "" "USES;PUBLIC;PRIVATE")
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}
             OUTPUT_VARIABLE folder)
  string(REPLACE "/" "_" name ${folder})
  list(TRANSFORM module_USES REPLACE "/" "_")
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${module_USES} ${module_PUBLIC} PRIVATE edvo_build ${module_PRIVATE})
  edvo_precompile(${name})
endfunction()

# edvo_precompile(target) parses the headers that most files read once for all targets; for those of
# EDVO_QUICK_TARGETS those of the command line and of JSON, too. Targets that share them are equally
# optimised: g++ 13 and later read them only so.
function(edvo_precompile target)
  if(target STREQUAL vo_core)
    target_precompile_headers(${target} PRIVATE ${EDVO_PRECOMPILED_HEADERS})
  elseif(target STREQUAL tools_precompiled_headers)
    target_precompile_headers(${target} PRIVATE ${EDVO_PRECOMPILED_HEADERS} ${EDVO_PRECOMPILED_TOOLS_HEADERS})
  elseif(target IN_LIST EDVO_QUICK_TARGETS)
    target_precompile_headers(${target} REUSE_FROM tools_precompiled_headers)
  else()
    target_precompile_headers(${target} REUSE_FROM vo_core)
  endif()
endfunction()

# edvo_compile_quickly(target) spends less on optimisation, in a target whose time to run is spent
# in libraries. g++ 12 takes Eigen's matrices for uninitialized at this level.
function(edvo_compile_quickly target)
  target_compile_options(${target} PRIVATE
    $<$<CONFIG:Release>:-O1>
    $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()
