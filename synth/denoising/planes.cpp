#include "synth/denoising/planes.h"

#include <cstddef>

namespace synth {
namespace {

constexpr float kLeastReflectance = 1e-3F;
constexpr float kOwnVariance = 0.3F;  // least variance, relative to what the pixel itself tells

}  // namespace

ColorPlanes color_planes_of(const cv::Mat_<cv::Vec3f>& image) {
  ColorPlanes channels;
  for (int i = 0; i < 3; ++i) {
    cv::extractChannel(image, channels[static_cast<std::size_t>(i)], i);
  }
  return channels;
}

ColorPlanes divisor_of(const ColorPlanes& reflectance) {
  ColorPlanes divisor;
  for (std::size_t i = 0; i < 3; ++i) {
    divisor[i] = cv::max(reflectance[i], kLeastReflectance);
  }
  return divisor;
}

Plane variance_of(const Plane& a, const Plane& b) {
  Plane variance(a.size());
  for (int v = 0; v < a.rows; ++v) {
    for (int u = 0; u < a.cols; ++u) {
      float sum = 0;
      float count = 0;
      visit_around({u, v}, a.size(), [&](const cv::Point& pixel) {
        const float difference = a(pixel) - b(pixel);
        sum += difference * difference;
        ++count;
      });
      const float own = a(v, u) - b(v, u);
      variance(v, u) = std::max(sum / count, kOwnVariance * own * own) / 2;
    }
  }
  return variance;
}

}  // namespace synth
