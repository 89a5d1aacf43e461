#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <opencv2/core.hpp>

namespace synth {

using Plane = cv::Mat_<float>;
using ColorPlanes = std::array<Plane, 3>;

/// The images that light is fitted in, a plane for each number, all of one size.
struct LightPlanes {
  std::array<ColorPlanes, 2> light;  ///< of each half and channel
  ColorPlanes variance;              ///< of the light of a half, per channel
  ColorPlanes normal;
  ColorPlanes reflectance;
  Plane nearness;  ///< relative to the picture's nearest surface
};

ColorPlanes color_planes_of(const cv::Mat_<cv::Vec3f>& image);

/// Returns what radiance is divided by to become light that arrives: the reflectance, or a least
/// one.
ColorPlanes divisor_of(const ColorPlanes& reflectance);

/// Returns the variance of a half, as the difference of the halves tells it: the mean of 3 x 3 px
/// around each pixel, or most of the pixel's own where that is greater.
Plane variance_of(const Plane& a, const Plane& b);

/// Calls `visit` with each pixel next to another, itself included, that is in the picture.
template <typename Visit>
void visit_around(const cv::Point& pixel, const cv::Size& size, Visit visit) {
  for (int v = std::max(0, pixel.y - 1); v <= std::min(size.height - 1, pixel.y + 1); ++v) {
    for (int u = std::max(0, pixel.x - 1); u <= std::min(size.width - 1, pixel.x + 1); ++u) {
      visit(cv::Point(u, v));
    }
  }
}

}  // namespace synth
