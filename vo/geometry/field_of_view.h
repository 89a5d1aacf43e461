#pragma once

#include <Eigen/Core>

#include "vo/geometry/camera.h"

namespace vo {

/// Returns whether the image shows a point, m in the camera frame, that nothing hides: whether it
/// is before the camera and its direction is the one that the lens images at its pixel. Far off the
/// axis `PinholeCamera::project` alone may lead back into the image, where the formula of the
/// distortion folds over, or beyond what a fisheye sees. Requires a camera that `validate` accepts.
bool is_in_view(const PinholeCamera& camera, const Eigen::Vector3d& p_camera);

}  // namespace vo
