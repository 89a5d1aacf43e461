#include "synth/sensor/flicker.h"

#include <cmath>
#include <numbers>

#include "vo/core/error.h"

namespace synth {

void FlickerOptions::validate() const {
  vo::require(mains_hz >= 0 && std::isfinite(mains_hz),
              "sensor.flicker: expected mains_hz at or above 0, got ", mains_hz);
  vo::require(depth >= 0 && depth <= 1, "sensor.flicker: expected a depth from 0 to 1, got ",
              depth);
  vo::require(std::isfinite(phase), "sensor.flicker: expected a finite phase, got ", phase);
}

double mean_flicker(const FlickerOptions& options, double middle, double exposure_time) {
  const double frequency = 2 * options.mains_hz;
  const double half_angle = std::numbers::pi * frequency * exposure_time;
  const double smoothing = half_angle > 0 ? std::sin(half_angle) / half_angle : 1;
  const double cycles = frequency * middle + options.phase;
  return 1 +
         options.depth * smoothing * std::cos(2 * std::numbers::pi * (cycles - std::floor(cycles)));
}

cv::Mat_<cv::Vec3f> with_flicker(const cv::Mat_<cv::Vec3f>& linear, const FlickerOptions& options,
                                 const Shutter& shutter, double stamp) {
  cv::Mat_<cv::Vec3f> result(linear.size());
  for (int v = 0; v < linear.rows; ++v) {
    const double middle = stamp + shutter.row_time(v, linear.rows);
    result.row(v) = linear.row(v) * mean_flicker(options, middle, shutter.exposure_time);
  }
  return result;
}

}  // namespace synth
