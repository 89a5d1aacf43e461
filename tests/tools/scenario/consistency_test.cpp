#include "tools/scenario/consistency.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace {

using vo::SE3;
using vo::Vector6d;

constexpr double kSigma = 1e-3;  // m and rad

/// A camera at rest at the origin; every frame's error is drawn from `factor` times its covariance.
/// The errors of poses are twice those of alignments, and so are their standard deviations.
std::vector<vo::TrackingResult> drawn_frames(double factor) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, kSigma * std::sqrt(factor));
  std::vector<vo::TrackingResult> frames(4001);
  frames.front().status = vo::TrackingStatus::initialized;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    vo::TrackingResult& frame = frames[i];
    Vector6d error;
    for (double& value : error) {
      value = normal(random);
    }
    frame.timestamp = 1;
    frame.status = vo::TrackingStatus::tracked;
    frame.alignment.T_cur_ref = SE3::exp(error);
    frame.alignment.covariance = kSigma * kSigma * vo::Matrix6d::Identity();
    frame.T_world_camera = SE3::exp(-2 * error);
    frame.absolute_covariance = 4 * frame.alignment.covariance;
  }
  return frames;
}

TEST(Consistency, ErrorsDrawnFromTheirCovariancesGiveOne) {
  const vo::Trajectory truth{{0, SE3()}, {2, SE3()}};
  for (const double factor : {1.0, 4.0}) {
    const std::vector<vo::TrackingResult> frames = drawn_frames(factor);
    for (const tools::Nees& nees :
         {tools::relative_nees(truth, frames), tools::absolute_nees(truth, frames)}) {
      EXPECT_NEAR(nees.median, factor, 0.05 * factor);
      EXPECT_NEAR(nees.p90, factor, 0.05 * factor);
    }
  }
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
  EXPECT_NEAR(tools::relative_nees(truth, {frame}).median, 4 / 5.348121, 1e-6);
}

/// The estimate's world need not be the truth's: only the motion since the first frame is judged.
TEST(Consistency, AbsoluteErrorsAreTakenSinceTheFirstFrame) {
  Vector6d motion;
  motion << 0.1, -0.2, 0.3, 0.05, 0.1, -0.15;
  const SE3 T_world_first = SE3::exp(motion);
  const vo::Trajectory truth{{0, T_world_first}, {1, T_world_first * SE3::exp(motion)}};
  Vector6d error = Vector6d::Zero();
  error[4] = 3 * kSigma;
  const vo::TrackingResult first{
      .timestamp = 0, .T_world_camera = {}, .status = vo::TrackingStatus::initialized};
  vo::TrackingResult frame{.timestamp = 1,
                           .T_world_camera = SE3::exp(motion) * SE3::exp(-error),
                           .status = vo::TrackingStatus::tracked};
  frame.absolute_covariance = kSigma * kSigma * vo::Matrix6d::Identity();
  EXPECT_NEAR(tools::absolute_nees(truth, {first, frame}).p90, 9 / 10.644641, 1e-6);
}

/// Returns a frame whose position is off by `error` m from the true one, `way` m along x.
vo::TrackingResult frame_off_by(double error, double timestamp, double way,
                                vo::TrackingStatus status) {
  return {.timestamp = timestamp,
          .T_world_camera = SE3(Eigen::Quaterniond::Identity(), {way, error, 0}),
          .status = status};
}

TEST(Consistency, TheGreatestSureErrorIsOfPosesNotInDoubt) {
  using enum vo::TrackingStatus;
  const SE3 T_world_first(Eigen::Quaterniond(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitZ())),
                          {5, 6, 7});  // the truth's world is not the estimate's
  vo::Trajectory truth;
  for (int i = 0; i < 5; ++i) {
    const SE3 T_first_cur(Eigen::Quaterniond::Identity(), {0.1 * i, 0, 0});
    truth.push_back({static_cast<double>(i), T_world_first * T_first_cur});
  }
  const std::vector<vo::TrackingResult> frames{
      frame_off_by(0, 0, 0, initialized), frame_off_by(0.02, 1, 0.1, tracked),
      frame_off_by(0.5, 2, 0.2, uncertain), frame_off_by(-0.03, 3, 0.3, tracked),
      frame_off_by(0.7, 4, 0.4, lost)};
  EXPECT_NEAR(tools::greatest_sure_error(truth, frames), 0.03, 1e-12);
}

TEST(Consistency, IsUnknownWithoutTrackedFrames) {
  const vo::Trajectory truth{{0, SE3()}, {2, SE3()}};
  EXPECT_TRUE(std::isnan(tools::greatest_sure_error(truth, {})));
  EXPECT_TRUE(std::isnan(tools::absolute_nees(truth, {}).median));
  EXPECT_TRUE(std::isnan(tools::relative_nees(truth, {vo::TrackingResult{.timestamp = 1}}).p90));
}

}  // namespace
