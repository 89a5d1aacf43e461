# edvo_component(name FOLDERS folder... HEADERS header... PUBLIC target...) makes the library libedvo_NAME,
# which is installed and which other projects link as edvo::NAME, of the modules of some folders. HEADERS
# are those that users include; they are installed with all that they include, and PUBLIC are the
# targets of other projects whose headers those include. Which components it links, and which targets
# besides, follows from its modules. It is shared where BUILD_SHARED_LIBS is set: then what its headers
# declare is visible outside, and what other components need of it.
function(edvo_component name)
  cmake_parse_arguments(PARSE_ARGV 1 component "" "" "FOLDERS;HEADERS;PUBLIC")
  list(TRANSFORM component_FOLDERS REPLACE "/" "_" OUTPUT_VARIABLE modules)
  set(objects)
  foreach(module IN LISTS modules)
    list(APPEND objects $<TARGET_OBJECTS:${module}>)
    set_property(TARGET ${module} PROPERTY EDVO_COMPONENT edvo_${name})
  endforeach()
  edvo_component_links("${modules}" uses links)
  list(REMOVE_ITEM links ${component_PUBLIC} "")

  set(library edvo_${name})
  add_library(${library} ${objects})
  add_library(edvo::${name} ALIAS ${library})
  target_compile_features(${library} PUBLIC cxx_std_20)
  target_include_directories(${library} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/edvo>)
  target_link_libraries(${library} PUBLIC ${uses} ${component_PUBLIC} PRIVATE ${links})
  set_target_properties(${library} PROPERTIES
    EXPORT_NAME ${name} LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION} SOVERSION ${EDVO_SOVERSION}
    EDVO_COMPONENT_FOLDERS "${component_FOLDERS}" EDVO_COMPONENT_HEADERS "${component_HEADERS}")
  list(TRANSFORM uses REPLACE "^edvo_" "" OUTPUT_VARIABLE used_names)
  set_property(GLOBAL APPEND PROPERTY EDVO_COMPONENTS ${name})
  set_property(GLOBAL PROPERTY EDVO_USES_${name} ${used_names})
  if(BUILD_SHARED_LIBS)
    edvo_export_declarations(${library})
  endif()
  if(EDVO_INSTALL)
    edvo_install_component(${name} "${uses}" "${component_PUBLIC}" "${links}")
  endif()
endfunction()

# edvo_component_links(modules uses others) lists what modules link outside themselves: other components, and
# targets of other projects, but for those that are headers alone.
function(edvo_component_links modules uses_result others_result)
  set(uses)
  set(others)
  foreach(module IN LISTS modules)
    get_target_property(links ${module} INTERFACE_LINK_LIBRARIES)
    list(TRANSFORM links REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1")
    foreach(link IN LISTS links)
      if(link STREQUAL edvo_build OR link IN_LIST modules)
        continue()
      endif()
      if(NOT TARGET ${link})
        list(APPEND others ${link})
        continue()
      endif()
      get_target_property(component ${link} EDVO_COMPONENT)
      get_target_property(type ${link} TYPE)
      get_target_property(behind ${link} INTERFACE_LINK_LIBRARIES)
      if(component)
        list(APPEND uses ${component})
      elseif(NOT type STREQUAL INTERFACE_LIBRARY OR behind)
        list(APPEND others ${link})
      endif()
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES uses)
  list(REMOVE_DUPLICATES others)
  set(${uses_result} ${uses} PARENT_SCOPE)
  set(${others_result} ${others} PARENT_SCOPE)
endfunction()

# edvo_export_declarations(library) makes visible outside a shared library what its own headers declare, as
# far as they are installed or another component includes them, and hides all else.
function(edvo_export_declarations library)
  get_target_property(folders ${library} EDVO_COMPONENT_FOLDERS)
  get_target_property(headers ${library} EDVO_COMPONENT_HEADERS)
  set(declarations)
  foreach(folder IN LISTS folders)
    file(GLOB found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
    list(APPEND declarations ${found})
  endforeach()
  set(script ${PROJECT_BINARY_DIR}/generated/${library}.map)
  add_custom_command(
    OUTPUT ${script}
    COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} "-DFOLDERS=${folders}" "-DHEADERS=${headers}"
            -DRESULT=${script} -P ${PROJECT_SOURCE_DIR}/tools/cmake/export_declarations.cmake
    DEPENDS ${declarations} ${PROJECT_SOURCE_DIR}/tools/cmake/export_declarations.cmake
            ${PROJECT_SOURCE_DIR}/tools/cmake/included_headers.cmake
    VERBATIM)
  target_sources(${library} PRIVATE ${script})
  set_property(TARGET ${library} APPEND PROPERTY LINK_DEPENDS ${script})
  target_link_options(${library} PRIVATE -Wl,--version-script=${script} -Wl,--no-undefined)
endfunction()

# edvo_install_component(name uses public links) installs a component: its library, its headers, its part
# of the CMake package and its file for pkg-config.
function(edvo_install_component name uses public_links links)
  set(library edvo_${name})
  install(TARGETS ${library} EXPORT ${library}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT ${library} NAMESPACE edvo:: FILE ${library}-targets.cmake
          DESTINATION ${EDVO_PACKAGE_DIR} COMPONENT development)
  get_target_property(headers ${library} EDVO_COMPONENT_HEADERS)
  install(CODE "set(EDVO_ROOT \"${PROJECT_SOURCE_DIR}\")
set(EDVO_HEADERS \"${headers}\")
set(EDVO_INCLUDEDIR \"${CMAKE_INSTALL_INCLUDEDIR}/edvo\")
include(\"${PROJECT_SOURCE_DIR}/tools/cmake/install_headers.cmake\")" COMPONENT development)
  edvo_write_pkg_config(${name} "${uses}" "${public_links}" "${links}")
endfunction()

# edvo_write_pkg_config(name uses public links) writes and installs edvo-NAME.pc.
function(edvo_write_pkg_config name uses public_links links)
  list(TRANSFORM uses REPLACE "^edvo_" "edvo-" OUTPUT_VARIABLE required)
  set(flags "-I\${includedir}/edvo")
  set(libraries "-L\${libdir} -ledvo_${name}")
  set(private_libraries)
  foreach(target IN LISTS public_links)
    if(target STREQUAL Eigen3::Eigen)
      list(APPEND required "eigen3 >= 3.4")
      continue()
    endif()
    edvo_library_flag(${target} flag)
    string(APPEND libraries " ${flag}")
    get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
    foreach(folder IN LISTS folders)
      string(APPEND flags " -isystem ${folder}")
    endforeach()
  endforeach()
  foreach(target IN LISTS links)
    edvo_library_flag(${target} flag)
    list(APPEND private_libraries ${flag})
  endforeach()
  list(JOIN required ", " required)
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
             OUTPUT_VARIABLE prefix)
  list(JOIN private_libraries " " private_libraries)
  configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/edvo.pc.in
                 ${PROJECT_BINARY_DIR}/generated/edvo-${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/generated/edvo-${name}.pc
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()

# edvo_library_flag(target result) returns how a linker is told of a target: -lNAME.
function(edvo_library_flag target result)
  if(NOT TARGET ${target})
    set(${result} -l${target} PARENT_SCOPE)
    return()
  endif()
  set(location)
  foreach(property IN ITEMS IMPORTED_LOCATION IMPORTED_LOCATION_RELEASE IMPORTED_LOCATION_NONE
                            IMPORTED_LOCATION_RELWITHDEBINFO INTERFACE_LINK_LIBRARIES)
    get_target_property(location ${target} ${property})
    if(location)
      break()
    endif()
  endforeach()
  cmake_path(GET location FILENAME file)
  string(REGEX REPLACE "^lib([^.]*)\\..*$" "-l\\1" flag "${file}")
  set(${result} ${flag} PARENT_SCOPE)
endfunction()

# edvo_install_package() installs the CMake package of all components: find_package(edvo COMPONENTS ...).
function(edvo_install_package)
  get_property(EDVO_COMPONENTS GLOBAL PROPERTY EDVO_COMPONENTS)
  set(EDVO_USES)
  foreach(name IN LISTS EDVO_COMPONENTS)
    get_property(uses GLOBAL PROPERTY EDVO_USES_${name})
    list(JOIN uses " " uses)
    string(APPEND EDVO_USES "set(_edvo_uses_${name} ${uses})\n")
  endforeach()
  configure_package_config_file(tools/cmake/edvoConfig.cmake.in
    ${PROJECT_BINARY_DIR}/generated/edvoConfig.cmake INSTALL_DESTINATION ${EDVO_PACKAGE_DIR})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/edvoConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/generated/edvoConfig.cmake
                ${PROJECT_BINARY_DIR}/generated/edvoConfigVersion.cmake
                tools/cmake/FindOpenCVMinimal.cmake tools/cmake/FindDraco.cmake
          DESTINATION ${EDVO_PACKAGE_DIR} COMPONENT development)
  install(FILES ${PROJECT_BINARY_DIR}/generated/vo/core/version.h
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/edvo/vo/core COMPONENT development)
endfunction()
