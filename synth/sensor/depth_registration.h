#pragma once

#include <Eigen/Core>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"

namespace synth {

/// Depth of a camera without distortion, else of the same intrinsics, that stands at `offset` (m,
/// in the colour camera's axes, which it shares), as it appears in the colour camera. Each depth
/// pixel covers the pixels that its corners come to lie in, as librealsense does it; the nearest
/// wins. What the depth camera does not see has no depth.
vo::DepthImage registered(const vo::DepthImage& depth, const vo::PinholeCamera& color,
                          const Eigen::Vector3d& offset);

}  // namespace synth
