#include "synth/sensor/noise_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/sensor/preset.h"

namespace synth {
namespace {

const vo::RgbdCamera kCamera{vo::PinholeCamera::from_horizontal_fov(320, 240, 60), 5000};
const double kRounding = 1 / (5000 * std::sqrt(12.0));  // m

TEST(NoiseModel, OfAPerfectSensorIsTheRoundingOfDepthUnits) {
  const vo::DepthNoise noise = depth_noise_model({}, kCamera);
  EXPECT_NEAR(noise.constant, kRounding, 1e-9);
  EXPECT_NEAR(noise.linear, 0, 1e-9);
  EXPECT_NEAR(noise.quadratic, 0, 1e-9);
}

/// sigma_z = z^2 sigma_d / (f b), of the disparity's noise and of its steps.
TEST(NoiseModel, OfStereoIsThatOfItsDisparity) {
  const vo::DepthNoise noise =
      depth_noise_model(preset_options(SensorPreset::realsense_d435), kCamera);
  EXPECT_NEAR(noise.quadratic, std::hypot(0.08, 0.03125 / std::sqrt(12.0)) / 21.2, 1e-8);
  EXPECT_NEAR(noise.constant, std::hypot(0.001 / std::sqrt(12.0), kRounding), 1e-7);
  EXPECT_NEAR(noise.linear, 0, 1e-6);
}

TEST(NoiseModel, FollowsEveryPresetsDeviation) {
  for (const auto& [preset, name] : enum_names(SensorPreset{})) {
    const SensorOptions sensor = preset_options(preset);
    const vo::DepthNoise noise = depth_noise_model(sensor, kCamera);
    for (double z = 0.5; z <= 5; z += 0.25) {
      const double sigma = std::sqrt(depth_variance(sensor, kCamera, z));
      EXPECT_NEAR(noise.sigma(z), sigma, 0.12 * sigma) << name << " at " << z << " m";
    }
  }
}

}  // namespace
}  // namespace synth
