# Installs the headers EDVO_HEADERS and all that they include from EDVO_ROOT into EDVO_INCLUDEDIR below the
# prefix.
include(${EDVO_ROOT}/tools/cmake/included_headers.cmake)
edvo_included_headers(${EDVO_ROOT} headers ${EDVO_HEADERS})
foreach(header IN LISTS headers)
  cmake_path(GET header PARENT_PATH folder)
  file(INSTALL DESTINATION ${CMAKE_INSTALL_PREFIX}/${EDVO_INCLUDEDIR}/${folder} TYPE FILE
       FILES ${EDVO_ROOT}/${header})
endforeach()
