# The rgbd module of OpenCV's contrib modules: opencv_rgbd. Only `edvo bench` asks for it, to compare
# with.
find_path(OpenCVRgbd_INCLUDE_DIR opencv2/rgbd/depth.hpp PATH_SUFFIXES opencv4)
find_library(OpenCVRgbd_LIBRARY opencv_rgbd)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVRgbd REQUIRED_VARS OpenCVRgbd_INCLUDE_DIR OpenCVRgbd_LIBRARY)
mark_as_advanced(OpenCVRgbd_INCLUDE_DIR OpenCVRgbd_LIBRARY)

if(OpenCVRgbd_FOUND AND NOT TARGET opencv_rgbd)
  add_library(opencv_rgbd UNKNOWN IMPORTED)
  set_target_properties(opencv_rgbd PROPERTIES
    IMPORTED_LOCATION ${OpenCVRgbd_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenCVRgbd_INCLUDE_DIR})
endif()
