# The videoio module of OpenCV: opencv_videoio. It is optional: videos and V4L2 cameras are read by it.
find_path(OpenCVVideoio_INCLUDE_DIR opencv2/videoio.hpp PATH_SUFFIXES opencv4)
find_library(OpenCVVideoio_LIBRARY opencv_videoio)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVVideoio REQUIRED_VARS OpenCVVideoio_INCLUDE_DIR OpenCVVideoio_LIBRARY)
mark_as_advanced(OpenCVVideoio_INCLUDE_DIR OpenCVVideoio_LIBRARY)

if(OpenCVVideoio_FOUND AND NOT TARGET opencv_videoio)
  add_library(opencv_videoio UNKNOWN IMPORTED)
  set_target_properties(opencv_videoio PROPERTIES
    IMPORTED_LOCATION ${OpenCVVideoio_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenCVVideoio_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES opencv_core)
endif()
