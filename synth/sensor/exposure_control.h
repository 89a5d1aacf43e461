#pragma once

#include <array>
#include <utility>
#include <vector>

namespace synth {

enum class ExposureBy {
  gain,  ///< amplification: noise grows in the dark
  time,  ///< exposure time: blur grows in the dark
};

constexpr auto enum_names(ExposureBy) {
  return std::array{std::pair{ExposureBy::gain, "gain"}, std::pair{ExposureBy::time, "time"}};
}

/// A control loop in logarithms: after `delay`, each frame takes the share 1 - exp(-dt /
/// time_constant) of the step from its setting to what was metered.
struct AutoExposureOptions {
  bool enabled = false;
  double time_constant = 0.3;  ///< s; 0 = at once
  double delay = 0.05;         ///< s from a frame to its effect
  ExposureBy by = ExposureBy::gain;
  double max_exposure_time = 0.03;  ///< s; beyond it, gain (by = time)

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, AutoExposureOptions& options) {
  visit("enabled", options.enabled, "each frame's median follows 18 % grey");
  visit("time_constant", options.time_constant, "of the exposure's approach, s");
  visit("delay", options.delay, "from a frame to its effect on the exposure, s");
  visit("by", options.by, "what the exposure is changed by");
  visit("max_exposure_time", options.max_exposure_time, "s; beyond it, gain (by = time)");
}

/// Gains of red and blue, and their control loop, which makes the mean of what is seen grey.
struct WhiteBalanceOptions {
  double red = 1;
  double blue = 1;
  bool enabled = false;
  double time_constant = 1;  ///< s; 0 = at once
  double delay = 0.05;       ///< s from a frame to its effect

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, WhiteBalanceOptions& options) {
  visit("red", options.red, "gain of red, beside the automatic one");
  visit("blue", options.blue, "gain of blue, beside the automatic one");
  visit("enabled", options.enabled, "automatic: the mean of what is seen becomes grey");
  visit("time_constant", options.time_constant, "of the automatic gains' approach, s");
  visit("delay", options.delay, "from a frame to its effect on the gains, s");
}

/// Of frames at these times: `wanted` by each frame, followed with a first-order lag that looks at
/// the last frame that is at least `delay` old and never at the frame itself. The first frame has
/// what it wants.
std::vector<double> followed(const std::vector<double>& times, const std::vector<double>& wanted,
                             double time_constant, double delay);

}  // namespace synth
