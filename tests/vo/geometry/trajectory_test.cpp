#include "vo/geometry/trajectory.h"

#include <gtest/gtest.h>

#include "tests/support/pose_near.h"

namespace {

using vo::SE3;
using vo::Vector6d;

vo::Trajectory screw_motion() {
  Vector6d velocity;
  velocity << 0.5, -0.2, 0.1, 0.3, 0.2, -0.4;
  vo::Trajectory trajectory;
  for (int i = 0; i <= 4; ++i) {
    trajectory.push_back({0.5 * i, SE3::exp(0.5 * i * velocity)});
  }
  return trajectory;
}

TEST(Trajectory, InterpolationOfAScrewMotionIsTheScrewMotion) {
  const vo::Trajectory trajectory = screw_motion();
  const Vector6d velocity = trajectory[1].T_world_camera.log() / 0.5;
  for (const double time : {0.0, 0.1, 0.5, 1.3, 2.0}) {
    const auto T_world_camera = vo::pose_at(trajectory, time);
    ASSERT_TRUE(T_world_camera.has_value()) << time;
    EXPECT_THAT(*T_world_camera,
                support::PoseNear(SE3::exp(time * velocity), support::PoseTolerance{1e-12, 1e-10}));
  }
}

TEST(Trajectory, HasNoPoseOutsideItsTime) {
  EXPECT_FALSE(vo::pose_at(screw_motion(), -1e-9).has_value());
  EXPECT_FALSE(vo::pose_at(screw_motion(), 2.0 + 1e-9).has_value());
  EXPECT_FALSE(vo::pose_at({}, 0).has_value());
}

TEST(Trajectory, PathLengthSumsTheSteps) {
  const vo::Trajectory trajectory = {{0, SE3(Eigen::Quaterniond::Identity(), {0, 0, 0})},
                                     {1, SE3(Eigen::Quaterniond::Identity(), {3, 4, 0})},
                                     {2, SE3(Eigen::Quaterniond::Identity(), {3, 4, 2})}};
  EXPECT_DOUBLE_EQ(vo::path_length(trajectory), 7);
}

}  // namespace
