#pragma once

#include <opencv2/core.hpp>

#include "synth/rendering/capture.h"

namespace synth {

/// The flicker of all light in the scene, as of lamps on alternating current: radiance times
/// 1 + depth cos(2 pi (2 mains_hz t + phase)), t being the time of the stamps.
struct FlickerOptions {
  double mains_hz =
      0;  ///< Hz of the alternating current, whose power pulses twice as often; 0 = steady
  double depth = 0.3;  ///< 0 to 1, share of the light that comes and goes
  double phase = 0;    ///< cycles of the light at time 0

  bool is_on() const { return mains_hz > 0 && depth > 0; }
  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, FlickerOptions& options) {
  visit("mains_hz", options.mains_hz,
        "of lamps, whose light pulses twice as often, Hz; 0 = steady");
  visit("depth", options.depth, "share of the light that comes and goes");
  visit("phase", options.phase, "of the light at time 0, cycles");
}

/// Returns the mean of the flickering light over an exposure, as a factor of the steady light: by
/// the integral in closed form. `middle` is the exposure's middle, s.
double mean_flicker(const FlickerOptions& options, double middle, double exposure_time);

/// Returns the image of linear light with each row multiplied by the mean flicker over its
/// exposure. `stamp` is the picture's, s.
cv::Mat_<cv::Vec3f> with_flicker(const cv::Mat_<cv::Vec3f>& linear, const FlickerOptions& options,
                                 const Shutter& shutter, double stamp);

}  // namespace synth
