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
# in libraries. g++ 12 takes Eigen's matrices for uninitialized at this level. Such a target can afford that the standard
# library checks indices, iterators and optionals, which ends the program rather than reading another's memory.
function(edvo_compile_quickly target)
  target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  target_compile_options(${target} PRIVATE
    $<$<CONFIG:Release>:-O1>
    $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()

# edvo_sources_behind(target result) lists the sources, relative to the project's folder, of a module and of
# all modules that it links.
function(edvo_sources_behind target result)
  set(open ${target})
  set(seen)
  set(found)
  while(open)
    list(POP_FRONT open module)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" module "${module}")
    if(module IN_LIST seen OR NOT TARGET "${module}")
      continue()
    endif()
    list(APPEND seen ${module})
    get_target_property(folder ${module} SOURCE_DIR)
    get_target_property(type ${module} TYPE)
    if(NOT type STREQUAL STATIC_LIBRARY OR NOT folder MATCHES "^${PROJECT_SOURCE_DIR}/")
      continue()
    endif()
    get_target_property(sources ${module} SOURCES)
    get_target_property(links ${module} INTERFACE_LINK_LIBRARIES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    list(APPEND found ${sources})
    list(APPEND open ${links})
  endwhile()
  list(SORT found)
  list(TRANSFORM found REPLACE "^${PROJECT_SOURCE_DIR}/" "")
  set(${result} ${found} PARENT_SCOPE)
endfunction()
