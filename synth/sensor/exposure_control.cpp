#include "synth/sensor/exposure_control.h"

#include <cmath>
#include <cstddef>

#include "synth/rendering/capture.h"
#include "vo/core/error.h"

namespace synth {
namespace {

void require_times(const char* name, double time_constant, double delay) {
  vo::require(time_constant >= 0 && delay >= 0 && std::isfinite(time_constant + delay), name,
              ": expected time_constant and delay at or above 0 s, got ", time_constant, ", ",
              delay);
}

}  // namespace

void AutoExposureOptions::validate() const {
  require_times("sensor.auto_exposure", time_constant, delay);
  vo::require(max_exposure_time > 0 && max_exposure_time <= Shutter::kLongest,
              "sensor.auto_exposure.max_exposure_time: expected above 0 and at most ",
              Shutter::kLongest, " s, got ", max_exposure_time);
}

void WhiteBalanceOptions::validate() const {
  require_times("sensor.white_balance", time_constant, delay);
  vo::require(red > 0 && blue > 0 && std::isfinite(red + blue),
              "sensor.white_balance: expected red and blue above 0, got ", red, ", ", blue);
}

std::vector<double> followed(const std::vector<double>& times, const std::vector<double>& wanted,
                             double time_constant, double delay) {
  constexpr double kSameTime = 1e-9;  // s
  std::vector<double> settings(wanted.begin(), wanted.begin() + (wanted.empty() ? 0 : 1));
  std::size_t seen = 0;
  for (std::size_t i = 1; i < wanted.size(); ++i) {
    while (seen + 1 < i && times[seen + 1] <= times[i] - delay + kSameTime) {
      ++seen;
    }
    const double step = times[i] - times[i - 1];
    const double share = time_constant > 0 ? 1 - std::exp(-step / time_constant) : 1;
    settings.push_back(settings.back() + share * (wanted[seen] - settings.back()));
  }
  return settings;
}

}  // namespace synth
