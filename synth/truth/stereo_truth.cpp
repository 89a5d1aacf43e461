#include "synth/truth/stereo_truth.h"

#include <algorithm>

namespace synth {

vo::SE3 T_left_right(double baseline) {
  return {Eigen::Quaterniond::Identity(), {baseline, 0, 0}};
}

cv::Mat_<float> disparity_truth(const PointImage& points, double focal_baseline) {
  cv::Mat_<float> disparity(points.size);
  std::transform(points.points.begin(), points.points.end(), disparity.begin(),
                 [&](const TrianglePoint& point) {
                   return point.exists() ? static_cast<float>(focal_baseline / point.depth) : 0.F;
                 });
  return disparity;
}

}  // namespace synth
