#include "tools/scenario/consistency.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace {

using vo::SE3;
using vo::Vector6d;

constexpr double kSigma = 1e-3;  // m and rad

/// A camera at rest at the origin; every frame's error is drawn from `factor` times its covariance.
std::vector<vo::TrackingResult> drawn_frames(double factor) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, kSigma * std::sqrt(factor));
  std::vector<vo::TrackingResult> frames(2001);
  for (vo::TrackingResult& frame : frames) {
    Vector6d error;
    for (double& value : error) {
      value = normal(random);
    }
    frame.timestamp = 1;
    frame.status = vo::TrackingStatus::tracked;
    frame.alignment.T_cur_ref = SE3::exp(error);
    frame.alignment.covariance = kSigma * kSigma * vo::Matrix6d::Identity();
  }
  return frames;
}

TEST(Consistency, ErrorsDrawnFromTheirCovariancesGiveOne) {
  const vo::Trajectory truth{{0, SE3()}, {2, SE3()}};
  EXPECT_NEAR(tools::nees_median(truth, drawn_frames(1)), 1, 0.07);
  EXPECT_NEAR(tools::nees_median(truth, drawn_frames(4)), 4, 0.28);
}

TEST(Consistency, ErrorsAreTakenAgainstTheReferencesTruePose) {
  Vector6d motion;
  motion << 0.1, -0.2, 0.3, 0.05, 0.1, -0.15;
  const SE3 T_world_ref = SE3::exp(motion);
  const vo::Trajectory truth{{0, T_world_ref}, {1, T_world_ref * SE3::exp(motion)}};
  Vector6d error = Vector6d::Zero();
  error[1] = 2 * kSigma;
  vo::TrackingResult frame;
  frame.timestamp = 1;
  frame.status = vo::TrackingStatus::tracked;
  frame.alignment.T_cur_ref = SE3::exp(error) * SE3::exp(-motion);
  frame.alignment.covariance = kSigma * kSigma * vo::Matrix6d::Identity();
  EXPECT_NEAR(tools::nees_median(truth, {frame}), 4 / 5.348121, 1e-6);
}

TEST(Consistency, IsUnknownWithoutTrackedFrames) {
  const vo::Trajectory truth{{0, SE3()}, {2, SE3()}};
  EXPECT_TRUE(std::isnan(tools::nees_median(truth, {})));
  EXPECT_TRUE(std::isnan(tools::nees_median(truth, {vo::TrackingResult{.timestamp = 1}})));
}

}  // namespace
