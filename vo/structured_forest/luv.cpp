#include "vo/structured_forest/luv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vo {
namespace {

constexpr int kSteps = 1024;
constexpr float kUnit = 1.0F / 270;
using LightnessTable = std::array<float, kSteps>;

LightnessTable make_lightness_table() {
  constexpr float kSlope = 29.0F * 29 * 29 / 27;  // slope of the linear part below (6 / 29)^3
  LightnessTable table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const float y = static_cast<float>(i) / kSteps;
    table[i] = kUnit * (y > 8 / kSlope ? 116 * std::pow(y, 1.0F / 3) - 16 : kSlope * y);
  }
  return table;
}

cv::Vec3f luv_of(const cv::Vec3f& rgb, const LightnessTable& lightness) {
  constexpr float kWhiteU = 0.197833F;
  constexpr float kWhiteV = 0.468331F;
  const float x = 0.430574F * rgb[0] + 0.341550F * rgb[1] + 0.178325F * rgb[2];
  const float y = 0.222015F * rgb[0] + 0.706655F * rgb[1] + 0.071330F * rgb[2];
  const float z = 0.020183F * rgb[0] + 0.129553F * rgb[1] + 0.939180F * rgb[2];
  const float scale = 1 / (x + 15 * y + 3 * z + 1e-35F);
  const int step = std::clamp(static_cast<int>(kSteps * y), 0, kSteps - 1);
  const float l = lightness[static_cast<std::size_t>(step)];
  return {l, l * 13 * (4 * x * scale - kWhiteU) + 88 * kUnit,
          l * 13 * (9 * y * scale - kWhiteV) + 134 * kUnit};
}

}  // namespace

cv::Mat_<cv::Vec3f> rgb_to_luv(const cv::Mat_<cv::Vec3f>& rgb) {
  const LightnessTable lightness = make_lightness_table();
  cv::Mat_<cv::Vec3f> luv(rgb.size());
  std::transform(rgb.begin(), rgb.end(), luv.begin(),
                 [&](const cv::Vec3f& pixel) { return luv_of(pixel, lightness); });
  return luv;
}

}  // namespace vo
