#include "vo/evaluation/relative_error.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/example_trajectory.h"

namespace vo {
namespace {

constexpr double kRelativeRounding = 1e-10;  // m and deg
constexpr double kDegrees = 180 / std::numbers::pi;

Vector6d drift(const Eigen::Vector3d& velocity, const Eigen::Vector3d& angular_velocity) {
  Vector6d result;
  result << velocity, angular_velocity;
  return result;
}

Trajectory standing(std::size_t count, int poses_per_second) {
  Trajectory trajectory = support::example_trajectory(count, poses_per_second);
  for (StampedPose& pose : trajectory) {
    pose.T_world_camera = support::example_pose(0);
  }
  return trajectory;
}

EvaluationOptions over(double length, IntervalUnit unit) {
  return {.interval = {length, unit}};
}

/// All statistics are the same when all errors are.
void expect_constant(const Statistics& statistics, double value) {
  EXPECT_NEAR(statistics.rmse, value, kRelativeRounding);
  EXPECT_NEAR(statistics.mean, value, kRelativeRounding);
  EXPECT_NEAR(statistics.median, value, kRelativeRounding);
  EXPECT_NEAR(statistics.max, value, kRelativeRounding);
}

TEST(RelativeError, OfADriftOverSecondsIsVelocityTimesSeconds) {
  const Trajectory truth = standing(100, 20);
  const Trajectory estimate = support::drifting(truth, drift({0.03, 0, -0.04}, {0, 0, 0}));
  const EvaluationOptions options = over(1.5, IntervalUnit::seconds);
  expect_constant(relative_errors_tum(truth, estimate, options).translation, 0.075);
  expect_constant(relative_errors_evo(truth, estimate, options).translation, 0.075);
}

TEST(RelativeError, OfADriftOverFramesIsVelocityTimesFrameTime) {
  const Trajectory truth = standing(100, 20);
  const Trajectory estimate = support::drifting(truth, drift({0.03, 0, -0.04}, {0, 0, 0}));
  const EvaluationOptions options = over(6, IntervalUnit::frames);
  expect_constant(relative_errors_tum(truth, estimate, options).translation, 0.015);
  expect_constant(relative_errors_evo(truth, estimate, options).translation, 0.015);
}

TEST(RelativeError, OfATurningDriftIsAngularVelocityTimesSeconds) {
  const Trajectory truth = standing(100, 20);
  const Trajectory estimate = support::drifting(truth, drift({0, 0, 0}, {0, 0.02, 0}));
  const EvaluationOptions options = over(2, IntervalUnit::seconds);
  expect_constant(relative_errors_tum(truth, estimate, options).rotation_deg, 0.04 * kDegrees);
  expect_constant(relative_errors_evo(truth, estimate, options).rotation_deg, 0.04 * kDegrees);
  expect_constant(relative_errors_tum(truth, estimate, options).translation, 0);
}

TEST(RelativeError, HasTheSameRotationInBothDefinitions) {
  const Trajectory truth = support::example_trajectory(300, 30);
  const Trajectory estimate =
      support::drifting(truth, drift({0.01, 0.02, 0.03}, {0.03, -0.02, 0.01}));
  const RelativeErrors tum = relative_errors_tum(truth, estimate, {});
  const RelativeErrors evo = relative_errors_evo(truth, estimate, {});
  EXPECT_EQ(tum.pairs, evo.pairs);
  EXPECT_NEAR(tum.rotation_deg.rmse, evo.rotation_deg.rmse, kRelativeRounding);
  EXPECT_NEAR(tum.rotation_deg.median, evo.rotation_deg.median, kRelativeRounding);
  EXPECT_GT(std::abs(tum.translation.rmse - evo.translation.rmse), 1e-3);
}

TEST(RelativeError, OfTheBenchmarkIsTheTranslationBetweenTheEndsInTheStartFrame) {
  const Trajectory truth = {
      {0, SE3()}, {1, support::example_pose(1)}, {2, support::example_pose(2)}};
  const Trajectory estimate = {
      {0, SE3()}, {1, support::example_pose(1.1)}, {2, support::example_pose(2.1)}};
  const SE3 P = support::example_pose(1.1);
  const SE3 Q = support::example_pose(1);
  const Eigen::Vector3d tum =
      P.translation() - P.rotation_matrix() * Q.rotation_matrix().transpose() * Q.translation();
  const EvaluationOptions options = over(1, IntervalUnit::seconds);
  EXPECT_NEAR(relative_errors_tum(truth, estimate, options).translation.rmse, tum.norm(),
              kRelativeRounding);
  EXPECT_NEAR(relative_errors_evo(truth, estimate, options).translation.rmse,
              (P.translation() - Q.translation()).norm(), kRelativeRounding);
}

TEST(RelativeError, LeavesOutTheLastPoseAsTheBenchmarkDoes) {
  const Trajectory truth = support::example_trajectory(100, 30);
  const EvaluationOptions options = over(10, IntervalUnit::frames);
  EXPECT_EQ(relative_errors_tum(truth, truth, options).pairs, 89U);
  EXPECT_EQ(relative_errors_evo(truth, truth, options).pairs, 90U);
}

TEST(RelativeError, HasNoPairsWhenTheIntervalIsLongerThanTheTrajectory) {
  const Trajectory truth = support::example_trajectory(20, 10);
  for (const IntervalUnit unit : {IntervalUnit::seconds, IntervalUnit::frames}) {
    EXPECT_EQ(relative_errors_tum(truth, truth, over(1e9, unit)).pairs, 0U);
    EXPECT_EQ(relative_errors_evo(truth, truth, over(1e9, unit)).pairs, 0U);
  }
}

TEST(RelativeError, LeavesOutIntervalsThatStartOrEndInAGapOfTheTruth) {
  const Trajectory estimate = support::example_trajectory(100, 10);
  Trajectory truth = support::example_trajectory(1000, 100);
  truth.erase(truth.begin() + 492, truth.begin() + 509);  // the estimate's pose 50 at 5 s
  const EvaluationOptions options = over(10, IntervalUnit::frames);
  EXPECT_EQ(relative_errors_tum(truth, estimate, options).pairs, 87U);
  const RelativeErrors evo = relative_errors_evo(truth, estimate, options);
  EXPECT_EQ(evo.pairs, 89U);
  EXPECT_LT(evo.translation.max, kRelativeRounding);
}

TEST(RelativeError, AssociatesAnEstimateThatIsDenserThanTheTruth) {
  const Trajectory truth = support::example_trajectory(50, 10);
  const Trajectory estimate = support::example_trajectory(500, 100);
  const RelativeErrors evo = relative_errors_evo(truth, estimate, over(1, IntervalUnit::frames));
  EXPECT_EQ(evo.pairs, 49U);
  EXPECT_LT(evo.translation.max, kRelativeRounding);
}

}  // namespace
}  // namespace vo
