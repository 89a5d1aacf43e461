#include "synth/sensor/flicker.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace synth {
namespace {

using support::error_text;

/// The light at a time, s, as FlickerOptions defines it.
double light(const FlickerOptions& options, double time) {
  const double cycles = 2 * options.mains_hz * time + options.phase;
  return 1 + options.depth * std::cos(2 * std::numbers::pi * cycles);
}

TEST(Flicker, OverAnExposureIsTheMeanOfTheLight) {
  constexpr int kSteps = 20000;
  const FlickerOptions options{.mains_hz = 50, .depth = 0.6, .phase = 0.2};
  for (const double exposure_time : {0.001, 0.004, 0.013}) {
    const double middle = 0.377;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      sum += light(options, middle + exposure_time * ((i + 0.5) / kSteps - 0.5));
    }
    EXPECT_NEAR(mean_flicker(options, middle, exposure_time), sum / kSteps, 1e-8) << exposure_time;
  }
}

TEST(Flicker, OfAnInstantIsTheLightAtThatTime) {
  const FlickerOptions options{.mains_hz = 60, .depth = 0.4, .phase = -1.3};
  for (const double time : {-0.01, 0.0, 0.0021, 1700.25}) {
    EXPECT_NEAR(mean_flicker(options, time, 0), light(options, time), 1e-8) << time;
  }
}

TEST(Flicker, IsNotSeenInAnExposureOfWholePulses) {
  const FlickerOptions options{.mains_hz = 50, .depth = 1};
  for (const double middle : {0.0, 0.003, 0.007}) {
    EXPECT_NEAR(mean_flicker(options, middle, 0.01), 1, 1e-12);
    EXPECT_NEAR(mean_flicker(options, middle, 0.03), 1, 1e-12);
  }
}

TEST(Flicker, OfARollingShutterIsBandsAsWideAsAPulse) {
  const FlickerOptions options{.mains_hz = 50, .depth = 0.5};
  const Shutter shutter{.exposure_time = 0.002, .readout_time = 0.03};  // three pulses
  const cv::Mat_<cv::Vec3f> grey(301, 2, cv::Vec3f(0.5F, 0.25F, 0.125F));
  const cv::Mat_<cv::Vec3f> seen = with_flicker(grey, options, shutter, 0.5);
  const double smoothing = std::sin(0.2 * std::numbers::pi) / (0.2 * std::numbers::pi);
  for (int v = 0; v < grey.rows; ++v) {
    const double bands = 3.0 * (v - 150) / 301;  // 0.5 s is a whole number of pulses
    const double expected = 1 + 0.5 * smoothing * std::cos(2 * std::numbers::pi * bands);
    EXPECT_NEAR(seen(v, 0)[0], 0.5 * expected, 1e-6) << v;
    EXPECT_NEAR(seen(v, 1)[2], 0.125 * expected, 1e-6) << v;
  }
}

TEST(Flicker, OfAGlobalShutterIsAlikeInAllRows) {
  const cv::Mat_<cv::Vec3f> grey(9, 3, cv::Vec3f(0.5F, 0.5F, 0.5F));
  const cv::Mat_<cv::Vec3f> seen =
      with_flicker(grey, {.mains_hz = 50, .depth = 0.5}, {.exposure_time = 0.002}, 0.123);
  EXPECT_EQ(cv::norm(seen, cv::Mat_<cv::Vec3f>(9, 3, seen(0, 0)), cv::NORM_INF), 0);
}

TEST(Flicker, OutOfRangeIsAnError) {
  const auto fault = [](const FlickerOptions& options) {
    return error_text([&] { options.validate(); });
  };
  EXPECT_EQ(fault({.mains_hz = -50}), "sensor.flicker: expected mains_hz at or above 0, got -50");
  EXPECT_EQ(fault({.depth = 1.5}), "sensor.flicker: expected a depth from 0 to 1, got 1.5");
}

}  // namespace
}  // namespace synth
