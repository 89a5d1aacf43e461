#pragma once

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace synth {

/// Returns depth as it appears in the colour camera. The depth camera has the colour camera's
/// intrinsics without distortion. Each depth pixel covers the colour pixels that its corners
/// project to, as in librealsense; the nearest depth wins. Colour pixels that the depth camera does
/// not see have no depth.
vo::DepthImage registered(const vo::DepthImage& depth, const vo::PinholeCamera& color,
                          const vo::SE3& T_color_depth);

}  // namespace synth
