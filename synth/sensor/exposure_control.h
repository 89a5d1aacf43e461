#pragma once

#include <array>
#include <utility>
#include <vector>

namespace synth {

enum class ExposureBy {
  gain,  ///< changes amplification: noise grows in the dark
  time,  ///< changes exposure time: motion blur grows in the dark
};

constexpr auto enum_names(ExposureBy) {
  return std::array{std::pair{ExposureBy::gain, "gain"}, std::pair{ExposureBy::time, "time"}};
}

/// Automatic exposure, a control loop in logarithms: each frame takes the share 1 - exp(-dt /
/// time_constant) of the step from the last setting to what was metered `delay` earlier.
struct AutoExposureOptions {
  bool enabled = false;
  double time_constant = 0.3;  ///< s, time constant of the approach; 0 = at once
  double delay = 0.05;         ///< s from a metered frame to its effect
  ExposureBy by = ExposureBy::gain;
  double max_exposure_time = 0.03;  ///< s, limit with by = time, beyond which gain is used

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, AutoExposureOptions& options) {
  visit("enabled", options.enabled, "each frame's median follows 18 % grey");
  visit("time_constant", options.time_constant, "of the exposure's approach, s");
  visit("delay", options.delay, "from a frame to its effect on the exposure, s");
  visit("by", options.by, "what the exposure is changed by");
  visit("max_exposure_time", options.max_exposure_time, "s; beyond it, gain (by = time)");
}

/// White balance: gains of red and blue, and a control loop that makes the image's mean grey.
struct WhiteBalanceOptions {
  double red = 1;
  double blue = 1;
  bool enabled = false;
  double time_constant = 1;  ///< s, time constant of the approach; 0 = at once
  double delay = 0.05;       ///< s from a metered frame to its effect

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, WhiteBalanceOptions& options) {
  visit("red", options.red, "gain of red, beside the automatic one");
  visit("blue", options.blue, "gain of blue, beside the automatic one");
  visit("enabled", options.enabled, "automatic: the mean of what is seen becomes grey");
  visit("time_constant", options.time_constant, "of the automatic gains' approach, s");
  visit("delay", options.delay, "from a frame to its effect on the gains, s");
}

/// Returns each frame's setting at `times`, s: `wanted` followed with a first-order lag that looks
/// at the last frame that is at least `delay` old and never at the frame itself. The first frame
/// has the setting that it wants.
std::vector<double> followed(const std::vector<double>& times, const std::vector<double>& wanted,
                             double time_constant, double delay);

}  // namespace synth
