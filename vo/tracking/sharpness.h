#pragma once

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"

namespace vo {

/// One level of a frame and its own points there.
struct PointedImage {
  const EdgePointLevel& points;
  const PyramidLevel& level;
};

/// How strong the gradients of the current image are where both images show the same, over those of
/// the reference, each beside the mean intensity there: below 1 the current image is more blurred,
/// whatever the exposure. It is the geometric mean over the points of both, because each image's
/// points lie where its own gradients are strong. 1 where they have nothing in common.
double relative_sharpness(const PointedImage& reference, const PointedImage& current,
                          const SE3& T_cur_ref);

}  // namespace vo
