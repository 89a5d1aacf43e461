#pragma once

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"

namespace vo {

/// One level of a frame and the frame's own points there.
struct PointedImage {
  const EdgePointLevel& points;
  const PyramidLevel& level;
};

/// Returns how strong the current image's gradients are relative to the reference's where both show
/// the same scene, each divided by the mean intensity there: below 1 the current image is more
/// blurred, whatever the exposure. It is the geometric mean over the points of both frames, because
/// each image's points lie where its own gradients are strong. It is 1 if no point is seen in both.
double relative_sharpness(const PointedImage& reference, const PointedImage& current,
                          const SE3& T_cur_ref);

}  // namespace vo
