#include "tools/report/frame_errors.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/example_trajectory.h"
#include "vo/geometry/associate.h"

namespace {

TEST(FrameErrors, AConstantDriftIsTheSameErrorInEveryStep) {
  const vo::Trajectory truth = support::example_trajectory(20, 10);
  vo::Vector6d velocity;
  velocity << 0, 0, 0, 0.02, 0, 0;  // rad/s
  // P_i = Q_i exp(t_i v) with a rotation about one axis, so a step errs by exp(v / 10), conjugated.
  const std::vector<double> timestamps = vo::timestamps_of(truth);
  const tools::FramePoses poses = tools::poses_of_frames(truth, timestamps);
  const tools::FramePoses estimate =
      tools::poses_of_frames(support::drifting(truth, velocity), timestamps);
  const tools::FrameErrors errors = tools::frame_errors(poses, estimate, estimate);
  EXPECT_FALSE(errors.step_rotation_deg[0]);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(*errors.position_m[i], 0, 1e-12) << "it turns on the spot";
    EXPECT_NEAR(*errors.rotation_deg[i], timestamps[i] * 0.02 * 180 / std::numbers::pi, 1e-6);
  }
}

TEST(FrameErrors, AShiftIsAPositionErrorAndNoErrorOfAStep) {
  const vo::Trajectory truth = support::example_trajectory(8, 10);
  const std::vector<double> timestamps = vo::timestamps_of(truth);
  const tools::FramePoses poses = tools::poses_of_frames(truth, timestamps);
  const vo::SE3 T_shift(Eigen::Quaterniond::Identity(), {0, 0.003, 0.004});
  const tools::FramePoses shifted =
      tools::poses_of_frames(support::moved(T_shift, truth), timestamps);
  const tools::FrameErrors errors = tools::frame_errors(poses, shifted, shifted);
  for (std::size_t i = 1; i < truth.size(); ++i) {
    EXPECT_NEAR(*errors.position_m[i], 0.005, 1e-12);
    EXPECT_NEAR(*errors.step_translation_m[i], 0, 1e-12);
  }
}

TEST(FrameErrors, AMissingPoseLeavesItsErrorsOut) {
  const vo::Trajectory truth = support::example_trajectory(5, 10);
  vo::Trajectory estimate = truth;
  estimate.erase(estimate.begin() + 2);
  const std::vector<double> timestamps = vo::timestamps_of(truth);
  const tools::FramePoses poses = tools::poses_of_frames(truth, timestamps);
  const tools::FramePoses found = tools::poses_of_frames(estimate, timestamps);
  const tools::FrameErrors errors = tools::frame_errors(poses, found, found);
  EXPECT_FALSE(errors.position_m[2]);
  EXPECT_FALSE(errors.step_translation_m[2]);
  EXPECT_FALSE(errors.step_translation_m[3]) << "its step begins at the missing pose";
  EXPECT_TRUE(errors.step_translation_m[4]);
}

}  // namespace
