#include "vo/evaluation/evaluate.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/example_trajectory.h"
#include "vo/core/error.h"

namespace vo {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kRounding = 1e-12;         // m
constexpr double kRoundingDegrees = 1e-10;  // deg

SE3 example_motion() {
  Vector6d tangent;
  tangent << 1, -2, 3, 0.5, 0.7, -0.9;
  return SE3::exp(tangent);
}

Trajectory scaled(Trajectory trajectory, double scale) {
  for (auto& [timestamp, T_world_camera] : trajectory) {
    T_world_camera = {T_world_camera.rotation(), scale * T_world_camera.translation()};
  }
  return trajectory;
}

TEST(Summarize, AgreesWithTheClosedForms) {
  const Statistics odd = vo::summarize(std::vector<double>{7, 1, 4});
  EXPECT_DOUBLE_EQ(odd.rmse, std::sqrt(22.0));
  EXPECT_DOUBLE_EQ(odd.mean, 4);
  EXPECT_DOUBLE_EQ(odd.median, 4);
  EXPECT_DOUBLE_EQ(odd.max, 7);
  EXPECT_DOUBLE_EQ(vo::summarize(std::vector<double>{7, 1, 4, 2}).median, 3);
}

TEST(Summarize, KnowsNothingOfNothing) {
  const Statistics nothing = vo::summarize({});
  EXPECT_TRUE(std::isnan(nothing.rmse)) << "no error is not an error of zero";
  EXPECT_TRUE(std::isnan(nothing.median));
}

TEST(ErrorsOverTime, HaveTheStatisticsOfTheEvaluation) {
  const Trajectory truth = support::example_trajectory(100, 30);
  Trajectory estimate = scaled(truth, 1.1);
  for (std::size_t i = 0; i < estimate.size(); i += 3) {
    estimate[i].T_world_camera = estimate[i].T_world_camera * SE3::exp(0.01 * Vector6d::Ones());
  }
  for (const TrajectoryAlignment alignment :
       {TrajectoryAlignment::none, TrajectoryAlignment::se3, TrajectoryAlignment::sim3}) {
    const EvaluationOptions options{.alignment = alignment};
    const TrajectoryErrors errors = evaluate(truth, estimate, options);
    const ErrorsOverTime over_time = errors_over_time(truth, estimate, options);
    EXPECT_DOUBLE_EQ(vo::summarize(over_time.ate).rmse, errors.ate.rmse);
    EXPECT_DOUBLE_EQ(vo::summarize(over_time.rpe_translation).rmse, errors.rpe.translation.rmse);
    EXPECT_DOUBLE_EQ(vo::summarize(over_time.rpe_rotation_deg).max, errors.rpe.rotation_deg.max);
    EXPECT_EQ(over_time.timestamps.size(), errors.matched);
    EXPECT_EQ(over_time.rpe_timestamps.size(), errors.rpe.pairs);
  }
}

TEST(Evaluate, FindsNoErrorInTheTruth) {
  const Trajectory truth = support::example_trajectory(100, 30);
  const TrajectoryErrors errors = evaluate(truth, truth);
  EXPECT_LT(errors.ate.max, kRounding);
  EXPECT_LT(errors.rpe.translation.max, kRounding);
  EXPECT_LT(errors.rpe.rotation_deg.max, kRoundingDegrees);
  EXPECT_LT(errors.rpe_evo.translation.max, kRounding);
  EXPECT_LT(errors.rpe_evo.rotation_deg.max, kRoundingDegrees);
  EXPECT_EQ(errors.matched, truth.size());
  EXPECT_EQ(errors.matched_fraction, 1);
}

TEST(Evaluate, DoesNotDependOnTheWorldFrame) {
  const Trajectory truth = support::example_trajectory(100, 30);
  const TrajectoryErrors errors = evaluate(truth, support::moved(example_motion(), truth));
  EXPECT_LT(errors.ate.max, kRounding);
  EXPECT_LT(errors.rpe.translation.max, kRounding);
  EXPECT_LT(errors.rpe_evo.translation.max, kRounding);
}

TEST(Evaluate, ComparesPositionsAsTheyAreWithoutAlignment) {
  const Trajectory truth = support::example_trajectory(100, 30);
  const SE3 shift(Eigen::Quaterniond::Identity(), {0.3, 0, 0.4});
  const TrajectoryErrors errors =
      evaluate(truth, support::moved(shift, truth), {.alignment = TrajectoryAlignment::none});
  EXPECT_NEAR(errors.ate.rmse, 0.5, kRounding);
  EXPECT_NEAR(errors.ate.median, 0.5, kRounding);
}

TEST(Evaluate, AppliesTheFittedScaleToAllErrors) {
  const Trajectory truth = support::example_trajectory(100, 30);
  const Trajectory estimate = scaled(support::moved(example_motion(), truth), 4);
  const TrajectoryErrors errors =
      evaluate(truth, estimate, {.alignment = TrajectoryAlignment::sim3});
  EXPECT_NEAR(errors.scale, 0.25, kRounding);
  EXPECT_LT(errors.ate.max, kRounding);
  EXPECT_LT(errors.rpe.translation.max, kRounding);
  EXPECT_LT(errors.rpe_evo.translation.max, kRounding);
}

TEST(Evaluate, KeepsTheScaleUnlessAskedToFitIt) {
  const Trajectory truth = support::example_trajectory(100, 30);
  const TrajectoryErrors errors = evaluate(truth, scaled(truth, 4));
  EXPECT_EQ(errors.scale, 1);
  EXPECT_GT(errors.ate.rmse, 0.1);
}

TEST(AlignTrajectory, MovesEveryPositionAsTheAbsoluteErrorTakesIt) {
  const Trajectory truth = support::example_trajectory(50, 30);
  Trajectory estimate = truth;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const auto wave = static_cast<double>(i % 7);
    SE3& T_world_camera = estimate[i].T_world_camera;
    T_world_camera = {T_world_camera.rotation(),
                      1.5 * T_world_camera.translation() + Eigen::Vector3d(0.01 * wave, 2, 3)};
  }
  for (const auto& [alignment, name] : enum_names(TrajectoryAlignment{})) {
    const auto aligned = align_trajectory(truth, estimate, {.alignment = alignment});
    ASSERT_TRUE(aligned.has_value());
    const TrajectoryErrors judged = evaluate(truth, estimate, {.alignment = alignment});
    const TrajectoryErrors moved =
        evaluate(truth, *aligned, {.alignment = TrajectoryAlignment::none});
    EXPECT_NEAR(moved.ate.rmse, judged.ate.rmse, 1e-12) << name;
    EXPECT_NEAR(moved.ate.max, judged.ate.max, 1e-12) << name;
  }
  EXPECT_FALSE(align_trajectory(truth, {estimate.begin(), estimate.begin() + 2}).has_value());
}

TEST(Evaluate, AddsTheOffsetToTheEstimatesStamps) {
  const Trajectory truth = support::example_trajectory(100, 30);
  const TrajectoryErrors errors = evaluate(truth, support::delayed(truth, 2), {.time_offset = -2});
  EXPECT_EQ(errors.matched, truth.size());
  EXPECT_LT(errors.ate.max, kRounding);
  EXPECT_LT(errors.rpe.translation.max, kRounding);
  EXPECT_LT(errors.rpe_evo.translation.max, kRounding);
}

TEST(Evaluate, CountsTheEstimatesPosesThatMatch) {
  const Trajectory truth = support::example_trajectory(60, 30);
  const Trajectory estimate = support::example_trajectory(80, 30);
  const TrajectoryErrors errors = evaluate(truth, estimate);
  EXPECT_EQ(errors.matched, 60U);
  EXPECT_DOUBLE_EQ(errors.matched_fraction, 0.75);
}

TEST(Evaluate, SaysHowManyPosesMatchAndWhichTimesBothSpan) {
  const Trajectory truth = support::example_trajectory(31, 30, 100);
  const Trajectory estimate = support::example_trajectory(11, 10, 7);
  EXPECT_THAT([&] { evaluate(truth, estimate, {.time_offset = 0.5}); },
              ThrowsMessage<Error>(AllOf(HasSubstr("0 of 11 poses"), HasSubstr("at least 3"),
                                         HasSubstr("truth spans 100 s to 101 s"),
                                         HasSubstr("offset of 0.5 s spans 7.5 s to 8.5 s"))));
}

TEST(Evaluate, RefusesAnEmptyEstimate) {
  EXPECT_THAT([] { evaluate(support::example_trajectory(31, 30), {}); },
              ThrowsMessage<Error>(HasSubstr("has no poses")));
}

TEST(EvaluationOptions, RejectsWhatIsNoInterval) {
  EvaluationOptions options;
  options.interval.length = 0;
  EXPECT_THAT([&] { options.validate(); },
              ThrowsMessage<Error>(HasSubstr("expected a positive number, got 0")));
  options.interval = {1.5, IntervalUnit::frames};
  EXPECT_THAT([&] { options.validate(); },
              ThrowsMessage<Error>(HasSubstr("whole number of frames, got 1.5")));
  options.interval = {1.5, IntervalUnit::seconds};
  EXPECT_NO_THROW(options.validate());
}

}  // namespace
}  // namespace vo
