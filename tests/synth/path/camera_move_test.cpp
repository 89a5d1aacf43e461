#include "synth/path/camera_move.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/pose_near.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using support::error_text;
using support::PoseNear;
using testing::HasSubstr;

constexpr support::PoseTolerance kSamePose{.translation_m = 1e-12, .rotation_deg = 1e-6};
constexpr double kDuration = 4;  // s

/// Looks along -z: its right is +x, its down -y, its forward -z.
const MoveOptions kMove{
    .eye = {1, 2, 3}, .target = {1, 2, 0}, .by = {0.3, 0.2, 1}, .turn_deg = 60, .ramp = 1};

TEST(Still, RestsAtItsPose) {
  const CameraPath path = still(kMove);
  const vo::SE3 expected = vo::look_at({1, 2, 3}, {1, 2, 0}, Vector3d::UnitY());
  EXPECT_THAT(path(0), PoseNear(expected, kSamePose));
  EXPECT_THAT(path(99), PoseNear(expected, kSamePose));
}

TEST(Move, TurnsNoFurtherThanHasDigitsLeft) {
  MoveOptions options = kMove;
  options.turn_deg = -1e6;
  EXPECT_NO_THROW(pan(options, kDuration));
  options.turn_deg = 1e308;
  EXPECT_THAT(error_text([&] { pan(options, kDuration); }),
              HasSubstr("move.turn_deg: expected from -1e+06 to 1e+06 deg, got 1e+308"));
}

TEST(Dolly, GoesAlongTheFirstViewsAxesWithoutTurning) {
  const CameraPath path = dolly(kMove, kDuration);
  EXPECT_LT((path(0).translation() - Vector3d(1, 2, 3)).norm(), 1e-12);
  EXPECT_LT((path(kDuration).translation() - Vector3d(1.3, 1.8, 2)).norm(), 1e-12);
  EXPECT_LT((path(kDuration / 2).translation() - Vector3d(1.15, 1.9, 2.5)).norm(), 1e-12);
  EXPECT_LT((path(1.3).rotation().inverse() * path(0).rotation()).vec().norm(), 1e-12);
}

TEST(Dolly, RestsBeforeAndAfter) {
  const CameraPath path = dolly(kMove, kDuration);
  EXPECT_THAT(path(-1), PoseNear(path(0), kSamePose));
  EXPECT_THAT(path(kDuration + 1), PoseNear(path(kDuration), kSamePose));
}

/// Its length over the duration less one ramp.
TEST(Dolly, IsSteadyBetweenItsRamps) {
  const CameraPath path = dolly(kMove, kDuration);
  const double speed = kMove.by.norm() / (kDuration - kMove.ramp);
  for (const double time : {1.0, 1.5, 2.0, 2.9}) {
    const double distance = (path(time + 0.1).translation() - path(time).translation()).norm();
    EXPECT_NEAR(distance, 0.1 * speed, 1e-12) << "at " << time << " s";
  }
}

TEST(Dolly, ItsAccelerationIsContinuousAlsoWhereItStartsAndStops) {
  const CameraPath path = dolly(kMove, kDuration);
  constexpr double kStep = 1e-4;  // s
  const auto acceleration = [&](double time) -> Vector3d {
    return (path(time - kStep).translation() - 2 * path(time).translation() +
            path(time + kStep).translation()) /
           (kStep * kStep);
  };
  constexpr double kJerk = 6;  // m/s^3, more than the path has anywhere
  for (const double time : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    const Vector3d step = acceleration(time + kStep) - acceleration(time - kStep);
    EXPECT_LT(step.norm(), kJerk * 2 * kStep) << "at " << time << " s";
  }
}

TEST(Pan, TurnsToTheLeftAboutTheVerticalAndStaysLevel) {
  const CameraPath path = pan(kMove, kDuration);
  const double angle = 60 * std::numbers::pi / 180;
  const Vector3d gaze = path(kDuration).rotation() * Vector3d::UnitZ();
  EXPECT_LT((gaze - Vector3d(-std::sin(angle), 0, -std::cos(angle))).norm(), 1e-12);
  EXPECT_NEAR((path(1.7).rotation() * Vector3d::UnitX()).y(), 0, 1e-12);
  EXPECT_LT((path(1.7).translation() - kMove.eye).norm(), 1e-12);
}

/// The camera turns clockwise seen from behind it: its right becomes its old down.
TEST(Roll, TurnsClockwiseAboutTheOpticalAxis) {
  MoveOptions quarter = kMove;
  quarter.turn_deg = 90;
  const CameraPath path = roll(quarter, kDuration);
  EXPECT_LT((path(kDuration).rotation() * Vector3d::UnitX() + Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((path(1.7).rotation() * Vector3d::UnitZ() + Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(MoveOptions, WithoutARampItIsSteadyFromTheStart) {
  MoveOptions steady = kMove;
  steady.ramp = 0;
  const CameraPath path = dolly(steady, kDuration);
  EXPECT_LT((path(1).translation() - Vector3d(1.075, 1.95, 2.75)).norm(), 1e-12);
}

TEST(MoveOptions, NeedARampThatFitsAndALevelToLookFrom) {
  EXPECT_THAT(error_text([] { dolly(kMove, 1.5); }),
              HasSubstr("move.ramp: expected at most half of the duration, 0.75 s, got 1"));
  EXPECT_THAT(error_text([] {
                still({.eye = {0, 1, 0}, .target = {0, 3, 0}});
              }),
              HasSubstr("expected a target beside the eye"));
}

}  // namespace
}  // namespace synth
