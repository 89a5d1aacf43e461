#include "synth/rendering/infrared.h"

#include <algorithm>
#include <cmath>

namespace synth {

float pattern_along(const Projector& projector, const Eigen::Vector3d& direction) {
  const Eigen::Vector2d place =
      direction.head<2>().cwiseQuotient(direction.z() * projector.half_extent);
  if (!(direction.z() > 0) || !(place.cwiseAbs().maxCoeff() <= 1)) {
    return 0;
  }
  const cv::Mat_<float>& pattern = projector.pattern;
  const double x = std::clamp(pattern.cols * (place.x() + 1) / 2 - 0.5, 0.0, pattern.cols - 1.0);
  const double y = std::clamp(pattern.rows * (place.y() + 1) / 2 - 0.5, 0.0, pattern.rows - 1.0);
  const int u = std::max(0, std::min(static_cast<int>(x), pattern.cols - 2));
  const int v = std::max(0, std::min(static_cast<int>(y), pattern.rows - 2));
  const auto right = static_cast<float>(x - u);
  const auto down = static_cast<float>(y - v);
  const int next_u = std::min(u + 1, pattern.cols - 1);
  const int next_v = std::min(v + 1, pattern.rows - 1);
  const float above = (1 - right) * pattern(v, u) + right * pattern(v, next_u);
  const float below = (1 - right) * pattern(next_v, u) + right * pattern(next_v, next_u);
  return (1 - down) * above + down * below;
}

cv::Mat_<cv::Vec3f> grey_of(const cv::Mat_<cv::Vec3f>& radiance, double share) {
  const auto of_sum = static_cast<float>(share / 3);
  cv::Mat_<cv::Vec3f> grey(radiance.size());
  std::transform(radiance.begin(), radiance.end(), grey.begin(), [of_sum](const cv::Vec3f& rgb) {
    return cv::Vec3f::all((rgb[0] + rgb[1] + rgb[2]) * of_sum);
  });
  return grey;
}

}  // namespace synth
