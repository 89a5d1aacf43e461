#include "synth/path/hand_shake.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/pose_near.h"

namespace synth {
namespace {

using support::error_text;
using support::PoseNear;
using testing::HasSubstr;
using testing::Not;

constexpr ShakeOptions kShake{
    .amplitude = 0.01, .amplitude_deg = 0.5, .low_hz = 1, .high_hz = 6, .seed = 7};
constexpr support::PoseTolerance kShakeRounding{.translation_m = 1e-12, .rotation_deg = 1e-6};
constexpr support::PoseTolerance kClearlyApart{.translation_m = 1e-4, .rotation_deg = 1e-3};
constexpr double kRate = 30;       // Hz
constexpr int kFrames = 30 * 120;  // long beside the period of the lowest beat

vo::SE3 at_rest(double /*time*/) {
  return {};
}

std::vector<vo::Vector6d> wobbles(const ShakeOptions& options) {
  const CameraPath path = with_hand_shake(at_rest, options);
  std::vector<vo::Vector6d> result;
  for (int i = 0; i < kFrames; ++i) {
    const vo::SE3 T = path(i / kRate);
    result.push_back(vo::SE3(T.rotation(), Eigen::Vector3d::Zero()).log());
    result.back().head<3>() = T.translation();
  }
  return result;
}

TEST(HandShake, HasItsAmplitudeAsRootMeanSquareOnEveryAxis) {
  vo::Vector6d sum = vo::Vector6d::Zero();
  for (const vo::Vector6d& wobble : wobbles(kShake)) {
    sum += wobble.cwiseAbs2();
  }
  const vo::Vector6d rms = (sum / kFrames).cwiseSqrt();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(rms[axis], 0.01, 0.001) << "m, axis " << axis;
    EXPECT_NEAR(rms[axis + 3] * 180 / std::numbers::pi, 0.5, 0.05) << "deg, axis " << axis;
  }
}

/// Fourier's sums over whole seconds, by definition. What a finite record leaks beyond the band is
/// less than a hundredth.
TEST(HandShake, HasItsPowerWithinItsBand) {
  const std::vector<vo::Vector6d> shake = wobbles(kShake);
  double inside = 0;
  double outside = 0;
  for (int k = 1; k < 12 * 20; ++k) {
    const double hz = k / 20.0;
    std::complex<double> sum = 0;
    for (int i = 0; i < kFrames; ++i) {
      const double window = 1 - std::cos(2 * std::numbers::pi * i / kFrames);
      sum += window * shake[static_cast<std::size_t>(i)].x() *
             std::polar(1.0, -2 * std::numbers::pi * hz * i / kRate);
    }
    (hz > 0.9 && hz < 6.1 ? inside : outside) += std::norm(sum);
  }
  EXPECT_LT(outside, 0.01 * inside);
}

TEST(HandShake, IsAFunctionOfItsSeed) {
  ShakeOptions other = kShake;
  other.seed = 8;
  const vo::SE3 T = with_hand_shake(at_rest, kShake)(0.7);
  EXPECT_THAT(with_hand_shake(at_rest, kShake)(0.7), PoseNear(T, kShakeRounding));
  EXPECT_THAT(with_hand_shake(at_rest, other)(0.7), Not(PoseNear(T, kClearlyApart)));
}

TEST(HandShake, MovesTheCameraInItsOwnAxes) {
  const vo::SE3 T_world_camera(Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5), {1, 2, 3});
  const CameraPath held = with_hand_shake([&](double) { return T_world_camera; }, kShake);
  const vo::SE3 T_camera_shaken = with_hand_shake(at_rest, kShake)(1.1);
  EXPECT_THAT(held(1.1), PoseNear(T_world_camera * T_camera_shaken, kShakeRounding));
}

TEST(HandShake, NeedsABand) {
  EXPECT_THAT(error_text([] { with_hand_shake(at_rest, {.low_hz = 3, .high_hz = 2}); }),
              HasSubstr("shake: expected 0 < low_hz < high_hz, got 3 and 2"));
}

}  // namespace
}  // namespace synth
