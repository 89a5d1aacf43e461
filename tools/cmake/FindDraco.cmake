# Debian's draco: its own package file names a static library that Debian does not ship.
find_path(Draco_INCLUDE_DIR draco/compression/decode.h)
find_library(Draco_LIBRARY draco)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Draco REQUIRED_VARS Draco_LIBRARY Draco_INCLUDE_DIR)
if(Draco_FOUND AND NOT TARGET draco)
  add_library(draco UNKNOWN IMPORTED)
  set_target_properties(draco PROPERTIES IMPORTED_LOCATION ${Draco_LIBRARY}
                                         INTERFACE_INCLUDE_DIRECTORIES ${Draco_INCLUDE_DIR})
  # Debian's draco exports a tinygltf of its own, of another layout: ours must come first.
  set_property(TARGET TinyGLTF::TinyGLTF APPEND PROPERTY INTERFACE_LINK_LIBRARIES draco)
endif()
