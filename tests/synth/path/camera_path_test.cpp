#include "synth/path/camera_path.h"

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
using support::PoseTolerance;
using testing::HasSubstr;

constexpr double kRounding = 1e-12;  // m
constexpr PoseTolerance kSameSplinePose{.translation_m = 1e-12, .rotation_deg = 1e-6};

const OrbitOptions kOrbit{
    .centre = {1, 2, -3}, .radius = 2.5, .height = 0.7, .period = 8, .start_deg = 30};

TEST(Orbit, KeepsItsDistanceAndLooksAtTheCentre) {
  const CameraPath path = orbit(kOrbit);
  for (const double time : {-3.0, 0.0, 0.37, 1.9, 4.4, 9.0}) {
    const Vector3d p_camera = path(time).inverse() * kOrbit.centre;
    const Vector3d on_the_axis(0, 0, std::hypot(kOrbit.radius, kOrbit.height));
    EXPECT_LT((p_camera - on_the_axis).norm(), kRounding) << "at " << time << " s";
  }
}

TEST(Orbit, IsALevelCircleThatClosesAfterOnePeriod) {
  const CameraPath path = orbit(kOrbit);
  EXPECT_THAT(path(kOrbit.period), PoseNear(path(0), kSameSplinePose));
  for (const double time : {0.5, 1.9, 4.4, 6.0, 7.9}) {
    EXPECT_NEAR(path(time).translation().y(), 2.7, kRounding);
    EXPECT_NEAR((path(time).rotation() * Vector3d::UnitX()).y(), 0, kRounding) << "horizon";
  }
}

TEST(Orbit, StartsAtItsAngleAndRunsCounterClockwiseSeenFromAbove) {
  const CameraPath path = orbit({.radius = 1, .period = 4});
  EXPECT_LT((path(0).translation() - Vector3d(1, 0, 0)).norm(), kRounding);
  EXPECT_LT((path(1).translation() - Vector3d(0, 0, -1)).norm(), kRounding);
  const CameraPath turned = orbit({.radius = 1, .period = 4, .start_deg = 90});
  EXPECT_LT((turned(0).translation() - Vector3d(0, 0, -1)).norm(), kRounding);
}

TEST(Orbit, NeedsARadiusAndAPeriod) {
  EXPECT_THAT(error_text([] { orbit({.radius = 0}); }),
              HasSubstr("orbit: expected radius above 0, got 0"));
  EXPECT_THAT(error_text([] { orbit({.period = -1}); }),
              HasSubstr("orbit: expected period above 0, got -1"));
}

/// Uneven times, and a quaternion stored with the opposite sign, which is the same rotation.
vo::Trajectory control_poses() {
  const auto turn = [](double angle, const Vector3d& axis) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
  };
  vo::Trajectory poses = {{0.5, {turn(0, {0, 1, 0}), {0, 0, 0}}},
                          {1.0, {turn(0.4, {0, 1, 0}), {1, 0.2, 0}}},
                          {2.5, {turn(0.9, {0, 1, 0.3}), {2, 0.1, 1}}},
                          {3.0, {turn(1.2, {0.2, 1, 0}), {2, -0.3, 2}}},
                          {4.0, {turn(0.7, {0, 1, 0}), {1, 0, 3}}}};
  Eigen::Quaterniond opposite = poses[2].T_world_camera.rotation();
  opposite.coeffs() *= -1;
  poses[2].T_world_camera = {opposite, poses[2].T_world_camera.translation()};
  return poses;
}

TEST(Spline, PassesThroughItsControlPosesAndRestsOutsideOfThem) {
  const vo::Trajectory poses = control_poses();
  const CameraPath path = spline(poses);
  for (const vo::StampedPose& pose : poses) {
    EXPECT_THAT(path(pose.timestamp), PoseNear(pose.T_world_camera, kSameSplinePose));
  }
  EXPECT_THAT(path(-7), PoseNear(poses.front().T_world_camera, kSameSplinePose));
  EXPECT_THAT(path(99), PoseNear(poses.back().T_world_camera, kSameSplinePose));
}

/// Position and the third column of the rotation, which does not know the quaternion's sign.
Eigen::Matrix<double, 6, 1> state(const CameraPath& path, double time) {
  Eigen::Matrix<double, 6, 1> result;
  result << path(time).translation(), path(time).rotation() * Vector3d::UnitZ();
  return result;
}

TEST(Spline, ItsSecondDerivativeIsContinuousAcrossControlPoses) {
  const CameraPath path = spline(control_poses());
  constexpr double kStep = 1e-3;  // s
  const auto second_derivative = [&](double time) -> Eigen::Matrix<double, 6, 1> {
    return (state(path, time - kStep) - 2 * state(path, time) + state(path, time + kStep)) /
           (kStep * kStep);
  };
  constexpr double kJerk = 200;  // per s^3, more than the path has anywhere
  for (const double knot : {1.0, 2.5, 3.0}) {
    const auto before = second_derivative(knot - kStep);
    const auto after = second_derivative(knot + kStep);
    EXPECT_LT((after - before).norm(), kJerk * 2 * kStep) << "at " << knot << " s";
  }
}

TEST(Spline, ItsSecondDerivativeVanishesAtTheEnds) {
  const CameraPath path = spline(control_poses());
  constexpr double kStep = 1e-4;  // s
  const auto position = [&](double time) { return path(time).translation(); };
  const Vector3d second_derivative =
      (position(0.5) - 2 * position(0.5 + kStep) + position(0.5 + 2 * kStep)) / (kStep * kStep);
  EXPECT_LT(second_derivative.norm(), 1e-2);  // m/s^2; elsewhere it reaches several
}

TEST(Spline, OfTwoPosesMovesEvenly) {
  const CameraPath path = spline({{1, {}}, {3, {Eigen::Quaterniond::Identity(), {4, 0, 0}}}});
  EXPECT_LT((path(1.5).translation() - Vector3d(1, 0, 0)).norm(), kRounding);
}

TEST(Spline, NeedsTwoPosesInIncreasingTime) {
  EXPECT_THAT(error_text([] {
                spline({{0, {}}});
              }),
              HasSubstr("at least two control poses, got 1"));
  EXPECT_THAT(error_text([] { spline({{2, {}}, {2, {}}}); }), HasSubstr("got 2 s after 2 s"));
}

TEST(Sample, TakesPosesAtTheRateUntilTheDurationIsOver) {
  const CameraPath path = orbit(kOrbit);
  const vo::Trajectory trajectory = sample(path, 30, 2.0);
  ASSERT_EQ(trajectory.size(), 61U);
  EXPECT_EQ(trajectory[7].timestamp, 7.0 / 30);
  EXPECT_THAT(trajectory[7].T_world_camera, PoseNear(path(7.0 / 30), kSameSplinePose));
  EXPECT_EQ(sample(path, 30, 0.0999).size(), 3U);
  EXPECT_EQ(sample(path, 10, 0.3).size(), 4U) << "though 10 * 0.3 rounds to less than 3";
}

TEST(Sample, NeedsARate) {
  EXPECT_THAT(error_text([] { sample(orbit({}), 0, 1); }), HasSubstr("a rate above 0 Hz"));
}

}  // namespace
}  // namespace synth
