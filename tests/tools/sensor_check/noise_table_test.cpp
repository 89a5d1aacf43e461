#include "tools/sensor_check/noise_table.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/sensor/preset.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

using synth::SensorPreset;

TEST(NoiseTable, EveryPresetMeasuresAsItsFormulaSays) {
  for (const NoiseSample& sample : measure_noise(8, [](std::size_t, std::size_t) {})) {
    const std::string place = std::string(vo::to_string(sample.preset)) + " at " +
                              std::to_string(sample.depth) + " m, " +
                              std::to_string(sample.lean_deg) + " deg";
    EXPECT_NEAR(sample.measured.deviation / sample.formula.deviation, 1, 0.08) << place;
    EXPECT_NEAR(sample.measured.mean, sample.formula.mean, 0.15 * sample.formula.deviation)
        << place;
  }
}

TEST(NoiseTable, ImageNoiseOfEveryPresetIsItsFormulas) {
  for (const GreyNoise& sample : measure_grey_noise()) {
    EXPECT_NEAR(sample.measured / sample.formula, 1, 0.02) << vo::to_string(sample.preset);
  }
}

TEST(NoiseTable, FormulaOfKinectIsNguyensBetweenTheSteps) {
  synth::SensorOptions kinect = synth::preset_options(SensorPreset::kinect_v1);
  kinect.depth.disparity = {};
  kinect.depth.step = 0;
  EXPECT_NEAR(expected_error(kinect, 2, 0).deviation, 0.0012 + 0.0019 * 1.6 * 1.6, 2e-6);
}

TEST(NoiseTable, FormulaOfRealSenseIsItsSubpixelTimesDepthSquared) {
  synth::SensorOptions realsense = synth::preset_options(SensorPreset::realsense_d435);
  realsense.depth.disparity.step = 0;
  realsense.depth.step = 0;
  EXPECT_NEAR(expected_error(realsense, 2, 0).deviation, 0.08 * 4 / 21.2, 1e-6);
}

TEST(NoiseTable, FormulaOfSteps) {
  synth::SensorOptions steps;
  steps.depth.disparity = {.focal_baseline = 40, .step = 0.5};
  // 40 / 2.99 = 13.38 px becomes 13.5 px.
  EXPECT_NEAR(expected_error(steps, 2.99, 0).mean, 40 / 13.5 - 2.99, 1e-6);
}

}  // namespace
}  // namespace tools
