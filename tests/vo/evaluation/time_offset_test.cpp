#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/example_trajectory.h"
#include "vo/core/error.h"
#include "vo/evaluation/evaluate.h"

namespace vo {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kTolerance = 1e-3;  // s

class TimeOffsetOfAShift : public testing::TestWithParam<double> {};

TEST_P(TimeOffsetOfAShift, IsFoundInAllErrors) {
  const Trajectory truth = support::example_trajectory(1000, 100);
  const Trajectory estimate =
      support::delayed(support::example_trajectory(240, 30, 1), -GetParam());
  const TimeOffset offset = estimate_time_offset(truth, estimate, {});
  EXPECT_NEAR(offset.ate_offset, GetParam(), kTolerance);
  EXPECT_NEAR(offset.rpe_translation_offset, GetParam(), kTolerance);
  EXPECT_NEAR(offset.rpe_rotation_offset, GetParam(), kTolerance);
}

INSTANTIATE_TEST_SUITE_P(Shifts, TimeOffsetOfAShift, testing::Values(-0.1, -0.0372, 0, 0.0631));

TEST(TimeOffset, LeavesTheErrorOfTheInterpolatedTruth) {
  const Trajectory truth = support::example_trajectory(1000, 100);
  const Trajectory estimate = support::delayed(support::example_trajectory(240, 30, 1), 0.05);
  const TimeOffset offset = estimate_time_offset(truth, estimate, {});
  EXPECT_LT(offset.ate_rmse, 1e-4);               // m; 0.05 s are 6 cm
  EXPECT_LT(offset.rpe_translation_rmse, 1e-4);   // m
  EXPECT_LT(offset.rpe_rotation_rmse_deg, 1e-2);  // deg
}

TEST(TimeOffset, IsSearchedAroundTheGivenOne) {
  const Trajectory truth = support::example_trajectory(1000, 100);
  const Trajectory estimate = support::delayed(support::example_trajectory(240, 30, 1), 1000.03);
  const TimeOffset offset = estimate_time_offset(truth, estimate, {.time_offset = -1000});
  EXPECT_NEAR(offset.ate_offset, -1000.03, kTolerance);
}

TEST(TimeOffset, StaysWhereAllOffsetsAreEquallyGood) {
  Trajectory truth = support::example_trajectory(1000, 100);
  for (StampedPose& pose : truth) {
    pose.T_world_camera = SE3();
  }
  const TimeOffset offset = estimate_time_offset(truth, truth, {});
  EXPECT_EQ(offset.ate_offset, 0);
  EXPECT_EQ(offset.rpe_rotation_offset, 0);
}

TEST(TimeOffset, SaysHowManyPosesStayWithinTheTruth) {
  const Trajectory truth = support::example_trajectory(10, 30);
  EXPECT_THAT([&] { estimate_time_offset(truth, truth, {}, 1); },
              ThrowsMessage<Error>(HasSubstr("0 of 10 poses")));
}

}  // namespace
}  // namespace vo
