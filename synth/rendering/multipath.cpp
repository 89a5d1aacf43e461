#include "synth/rendering/multipath.h"

#include <cmath>
#include <numbers>

#include "vo/core/error.h"

namespace synth {

double MultipathOptions::wave_number() const {
  constexpr double kSpeedOfLight = 299792458;  // m/s
  return 2 * std::numbers::pi * frequency / kSpeedOfLight;
}

void MultipathOptions::validate() const {
  constexpr double kMinFrequency = 1e6;   // Hz; waves of 300 m
  constexpr double kMaxFrequency = 1e10;  // Hz; waves of 3 cm
  constexpr int kMaxSamples = 65536;
  constexpr int kMaxBounces = 64;
  constexpr int kMaxRadius = 50;
  vo::require(frequency == 0 || (frequency >= kMinFrequency && frequency <= kMaxFrequency),
              "sensor.depth.multipath: expected a frequency of 0 or from ", kMinFrequency, " to ",
              kMaxFrequency, " Hz, got ", frequency);
  vo::require(samples >= 1 && samples <= kMaxSamples,
              "sensor.depth.multipath: expected samples from 1 to ", kMaxSamples, ", got ",
              samples);
  vo::require(bounces >= 1 && bounces <= kMaxBounces,
              "sensor.depth.multipath: expected bounces from 1 to ", kMaxBounces, ", got ",
              bounces);
  vo::require(radius >= 0 && radius <= kMaxRadius,
              "sensor.depth.multipath: expected a radius from 0 to ", kMaxRadius, " px, got ",
              radius);
  vo::require(max_error >= 0 && std::isfinite(max_error),
              "sensor.depth.multipath: expected a max_error at or above 0 m, got ", max_error);
}

}  // namespace synth
