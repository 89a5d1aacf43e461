# OpenCV's core and imgproc: opencv_core, opencv_imgproc.
#
# OpenCV's own package configuration is used where it is installed. Debian's split packages
# (libopencv-core-dev, libopencv-imgproc-dev) do not bring it, so their headers and libraries are
# looked up by name.
find_package(OpenCV 4 CONFIG QUIET COMPONENTS core imgproc)
if(OpenCV_FOUND)
  set(OpenCVMinimal_FOUND TRUE)
  return()
endif()

find_path(OpenCVMinimal_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
set(required_variables OpenCVMinimal_INCLUDE_DIR)
foreach(component core imgproc)
  find_library(OpenCVMinimal_${component}_LIBRARY opencv_${component})
  list(APPEND required_variables OpenCVMinimal_${component}_LIBRARY)
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVMinimal REQUIRED_VARS ${required_variables})
mark_as_advanced(${required_variables})

if(OpenCVMinimal_FOUND)
  foreach(component core imgproc)
    if(NOT TARGET opencv_${component})
      add_library(opencv_${component} UNKNOWN IMPORTED)
      set_target_properties(opencv_${component} PROPERTIES
        IMPORTED_LOCATION ${OpenCVMinimal_${component}_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${OpenCVMinimal_INCLUDE_DIR})
    endif()
  endforeach()
  target_link_libraries(opencv_imgproc INTERFACE opencv_core)
endif()
