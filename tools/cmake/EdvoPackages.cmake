# Debian packages of what is installed, made by `cpack` in a build folder of shared libraries with the prefix
# /usr (tools/make-packages): edvo, libedvo0, libedvo-dev, python3-edvo.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME edvo)
set(CPACK_PACKAGE_VENDOR "")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has a synopsis of its own
set(CPACK_PACKAGE_CONTACT "edvo developers <edvo@edvo.invalid>")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
# One package's programs and libraries need another's, which dpkg-shlibdeps looks up where they are built.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/vo ${PROJECT_BINARY_DIR}/synth)

# edvo_package(component name section description depends) says what a package is called, and what it needs
# beside the libraries that it is linked with.
function(edvo_package component name section summary description depends)
  string(TOUPPER ${component} upper)
  foreach(pair IN ITEMS "PACKAGE_NAME;${name}" "PACKAGE_SECTION;${section}" "PACKAGE_DEPENDS;${depends}")
    list(POP_FRONT pair key)
    set(CPACK_DEBIAN_${upper}_${key} "${pair}" PARENT_SCOPE)
  endforeach()
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
  set(documents ${CMAKE_INSTALL_DATAROOTDIR}/doc/${name})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${documents} RENAME copyright COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/generated/${name}/changelog.Debian.gz DESTINATION ${documents}
          COMPONENT ${component})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/${name}/changelog.Debian CONTENT
"${name} (${PROJECT_VERSION}) unstable; urgency=medium

  * Changes are in CHANGELOG.md of the sources.

 -- ${CPACK_PACKAGE_CONTACT}  Wed, 25 Nov 2026 12:00:00 +0000
")
  execute_process(COMMAND gzip -9nf -k ${PROJECT_BINARY_DIR}/generated/${name}/changelog.Debian)
endfunction()

edvo_package(program edvo science
  "edge-direct visual odometry with a synthetic RGB-D laboratory"
  "edvo tracks RGB-D and single cameras by the photometric error of edge pixels,
renders RGB-D sequences with exact ground truth from glTF scenes, and tests
trackers against it."
  "")
edvo_package(runtime libedvo${EDVO_SOVERSION} libs
  "edge-direct visual odometry (shared libraries)"
  "Libraries of the odometries, of the evaluation of trajectories, of data sets
and of the renderer."
  "")
edvo_package(development libedvo-dev libdevel
  "edge-direct visual odometry (development files)"
  "Headers, the CMake package edvo and files of pkg-config."
  "libedvo${EDVO_SOVERSION} (= ${PROJECT_VERSION}), libeigen3-dev, libopencv-core-dev, libopencv-imgproc-dev")
file(WRITE ${PROJECT_BINARY_DIR}/generated/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/generated/triggers)
# What Python compiled of the module is nobody's file: without this it would stay when the package goes.
file(WRITE ${PROJECT_BINARY_DIR}/generated/prerm "#!/bin/sh
set -e
if command -v py3clean > /dev/null; then
  py3clean -p python3-edvo
fi
")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/generated/prerm)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
set(next_python ${Python3_VERSION_MAJOR}.${next_minor})
edvo_package(python python3-edvo python
  "edge-direct visual odometry (Python module)"
  "The module edvo: odometries, evaluation, sequences and the renderer on numpy
arrays."
  "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3 (<< ${next_python}), python3-numpy")
include(CPack)
