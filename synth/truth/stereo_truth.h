#pragma once

#include <opencv2/core.hpp>

#include "synth/ray_tracing/point_tracer.h"
#include "vo/geometry/se3.h"

namespace synth {

/// Returns the pose of the right camera of a rectified pair in the left one, `baseline` m apart.
vo::SE3 T_left_right(double baseline);

/// Returns u_left - u_right, px, of the pixels' points in a rectified pair: `focal_baseline`, px m,
/// over the depth; 0 where nothing was hit.
cv::Mat_<float> disparity_truth(const PointImage& points, double focal_baseline);

}  // namespace synth
