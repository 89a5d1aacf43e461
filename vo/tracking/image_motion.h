#pragma once

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"

namespace vo {

/// The motion of one frame's points in the image of another.
struct ImageMotion {
  double overlap = 0;  ///< share of the points that is in view
  double flow_px = 0;  ///< mean displacement of the points in view, px of the finest level
};

/// Measures the motion of the points of the coarsest level.
ImageMotion image_motion(const EdgePoints& points, const FramePyramid& frame, const SE3& T_cur_ref);

}  // namespace vo
