#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <pybind11/numpy.h>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace python {

/// Returns an image that shares an array's memory and keeps the array alive as long as any copy of
/// the image lives: height x width, or height x width x channels, of elements of OpenCV's `depth`
/// (CV_8U...). Rows may be apart, pixels of a row may not. Throws vo::Error naming `what`
/// otherwise.
cv::Mat shared_image(const pybind11::array& array, int depth, const std::string& what);

/// Returns an array that shares an image's memory and keeps it alive. It may not be written, since
/// images are shared; an empty image is None.
pybind11::object shared_array(const cv::Mat& image);

/// Returns an RGB-D frame of arrays: `image` uint8, height x width grey or height x width x 3 in
/// OpenCV's order blue, green, red; `depth` float32 in metres, uint16 in the camera's units, or
/// None. float32 and image share the arrays' memory. Throws vo::Error for other types.
vo::RgbdFrame frame_of(double timestamp, const pybind11::array& image,
                       const std::optional<pybind11::array>& depth, const vo::RgbdCamera& camera);

/// Returns T as a 4 x 4 matrix that takes homogeneous coordinates.
Eigen::Matrix4d matrix_of(const vo::SE3& T_a_b);

/// Returns the rigid motion of a 4 x 4 matrix. Throws vo::Error unless its upper left is a rotation
/// within 1e-6 and its last row is 0, 0, 0, 1.
vo::SE3 motion_of(const Eigen::Matrix4d& matrix);

}  // namespace python
