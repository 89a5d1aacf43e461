#include "synth/sensor/response.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "synth/scene/srgb.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace synth {
namespace {

std::vector<double> parse_table(const std::string& text) {
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  try {
    return vo::parse_reals(text, commas + 1);
  } catch (const vo::Error& error) {
    vo::fail("sensor.response.table: ", error.what());
  }
}

/// Returns the light, 0..1, at which a rising table reaches a brightness.
double light_of(const std::vector<double>& table, double brightness) {
  const auto above = std::lower_bound(table.begin() + 1, table.end() - 1, brightness);
  const auto i = static_cast<std::size_t>(above - table.begin());
  const double share = (brightness - table[i - 1]) / (table[i] - table[i - 1]);
  return (static_cast<double>(i - 1) + share) / static_cast<double>(table.size() - 1);
}

/// Returns the light that separates each code from the next one.
std::array<float, 255> code_thresholds(const ResponseOptions& options) {
  const std::vector<double> table =
      options.curve == ResponseCurve::table ? parse_table(options.table) : std::vector<double>{};
  std::array<float, 255> thresholds{};
  for (std::size_t code = 0; code < thresholds.size(); ++code) {
    const float brightness = (static_cast<float>(code) + 0.5F) / 255.0F;
    switch (options.curve) {
      case ResponseCurve::srgb:
        thresholds[code] = decode_srgb(brightness);
        break;
      case ResponseCurve::gamma:
        thresholds[code] = static_cast<float>(std::pow(brightness, options.gamma));
        break;
      case ResponseCurve::table:
        thresholds[code] = static_cast<float>(light_of(table, brightness));
        break;
    }
  }
  return thresholds;
}

}  // namespace

void ResponseOptions::validate() const {
  vo::require(gamma > 0 && std::isfinite(gamma), "sensor.response.gamma: expected above 0, got ",
              gamma);
  if (curve != ResponseCurve::table) {
    return;
  }
  const std::vector<double> values = parse_table(table);
  vo::require(values.size() >= 2 && values.front() == 0 && values.back() == 1,
              "sensor.response.table: expected at least two numbers from 0 to 1");
  for (std::size_t i = 1; i < values.size(); ++i) {
    vo::require(values[i] > values[i - 1], "sensor.response.table: expected rising numbers, got ",
                values[i], " after ", values[i - 1]);
  }
}

vo::ColorImage encode(const cv::Mat_<cv::Vec3f>& linear, const ResponseOptions& options) {
  const std::array<float, 255> thresholds = code_thresholds(options);
  const auto code = [&](float light) {
    const auto* above = std::upper_bound(thresholds.begin(), thresholds.end(), light);
    return light > 0 ? static_cast<std::uint8_t>(above - thresholds.begin()) : std::uint8_t{0};
  };
  vo::ColorImage image(linear.size());
  std::transform(linear.begin(), linear.end(), image.begin(), [&](const cv::Vec3f& rgb) {
    return cv::Vec3b(code(rgb[2]), code(rgb[1]), code(rgb[0]));
  });
  return image;
}

}  // namespace synth
