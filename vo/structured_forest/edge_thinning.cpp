#include "vo/structured_forest/edge_thinning.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vo/structured_forest/triangle_filter.h"

namespace vo {
namespace {

/// Interpolates bilinearly; beyond the border it returns the nearest value inside.
float interpolate(const cv::Mat_<float>& image, float u, float v) {
  u = std::clamp(u, 0.0F, static_cast<float>(image.cols - 1));
  v = std::clamp(v, 0.0F, static_cast<float>(image.rows - 1));
  const int left = static_cast<int>(u);
  const int top = static_cast<int>(v);
  const int right = std::min(left + 1, image.cols - 1);
  const int bottom = std::min(top + 1, image.rows - 1);
  const float a = u - static_cast<float>(left);
  const float b = v - static_cast<float>(top);
  return (1 - b) * ((1 - a) * image(top, left) + a * image(top, right)) +
         b * ((1 - a) * image(bottom, left) + a * image(bottom, right));
}

bool is_greatest(const cv::Mat_<float>& strength, const cv::Vec2f& across, const cv::Point& at,
                 int radius) {
  const float own = strength(at);
  for (int i = 1; i <= radius; ++i) {
    const float du = static_cast<float>(i) * across[0];
    const float dv = static_cast<float>(i) * across[1];
    const auto u = static_cast<float>(at.x);
    const auto v = static_cast<float>(at.y);
    if (interpolate(strength, u + du, v + dv) > own ||
        interpolate(strength, u - du, v - dv) >= own) {
      return false;
    }
  }
  return true;
}

}  // namespace

cv::Mat_<float> thinned(const cv::Mat_<float>& strength, const GradientImage& across, int radius) {
  cv::Mat_<float> result(strength.size(), 0.0F);
  for (int v = 0; v < strength.rows; ++v) {
    for (int u = 0; u < strength.cols; ++u) {
      if (strength(v, u) > 0 && is_greatest(strength, across(v, u), {u, v}, radius)) {
        result(v, u) = strength(v, u);
      }
    }
  }
  return result;
}

GradientImage across_ridges(const cv::Mat_<float>& strength, int radius) {
  const cv::Mat smooth = smoothed_by_triangle(strength, radius);
  cv::Mat_<float> uu;
  cv::Mat_<float> uv;
  cv::Mat_<float> vv;
  cv::Sobel(smooth, uu, CV_32F, 2, 0);
  cv::Sobel(smooth, uv, CV_32F, 1, 1);
  cv::Sobel(smooth, vv, CV_32F, 0, 2);
  GradientImage across(strength.size());
  for (int v = 0; v < strength.rows; ++v) {
    for (int u = 0; u < strength.cols; ++u) {
      const float angle = 0.5F * std::atan2(-2 * uv(v, u), vv(v, u) - uu(v, u));
      across(v, u) = {std::cos(angle), std::sin(angle)};
    }
  }
  return across;
}

}  // namespace vo
