#pragma once

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace vo {

/// Moves a depth image, as it is seen at one pose, to another pose near by: T_moved_depth takes the
/// camera's frame from the first to the second. `rays` are those of the camera's pixels. A cell of
/// two by two pixels takes the depths that were measured where its point was, found to first order
/// in the motion, and their change along the optical axis; depth is not interpolated. There is none
/// where that is outside the image, nor in an odd last row or column. The memory of `moved` is
/// reused if nobody else holds it.
void move_depth(const DepthImage& depth, const PinholeCamera& camera, const RayImage& rays,
                const SE3& T_moved_depth, DepthImage& moved);

}  // namespace vo
