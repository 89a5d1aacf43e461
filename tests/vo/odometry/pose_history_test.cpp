#include "vo/odometry/pose_history.h"

#include <gtest/gtest.h>

#include "tests/support/pose_near.h"

namespace {

using support::PoseNear;
using vo::MonoState;
using vo::SE3;

constexpr support::PoseTolerance kExact{1e-12, 1e-6};

SE3 pose(double seed) {
  return SE3::exp(
      (vo::Vector6d() << seed, 2 * seed, -seed, 0.3 * seed, 0.1, -0.2 * seed).finished());
}

SE3 scaled(const SE3& T, double scale) {
  return {T.rotation(), scale * T.translation()};
}

/// Two worlds that differ by a similarity: the joint of one camera moves all others.
TEST(MapJoint, IsTheSimilarityOfTheWorlds) {
  constexpr double kScale = 2.5;
  const SE3 T_to_from = pose(0.7);
  const auto in_other_world = [&](const SE3& T) { return T_to_from * scaled(T, kScale); };
  const vo::MapJoint joint{pose(0.4), in_other_world(pose(0.4)), kScale};
  for (const double seed : {-1.0, 0.1, 0.4, 2.0}) {
    EXPECT_THAT(joint(pose(seed)), PoseNear(in_other_world(pose(seed)), kExact));
  }
}

TEST(PoseHistory, JoinsThePosesSinceAnIndex) {
  vo::PoseHistory history;
  history.add(0, pose(0.1), MonoState::scale_uncertain);
  history.add(1, pose(0.2), MonoState::orienting);
  history.add(2, pose(0.3), MonoState::scale_uncertain);
  const vo::MapJoint joint{SE3(), pose(1), 2};
  history.join_since(1, joint, true);
  EXPECT_THAT(history.trajectory()[0].T_world_camera, PoseNear(pose(0.1), kExact));
  EXPECT_THAT(history.trajectory()[2].T_world_camera, PoseNear(joint(pose(0.3)), kExact));
  EXPECT_EQ(history.count(MonoState::scale_uncertain), 1U);
  EXPECT_EQ(history.count(MonoState::orienting), 1U);
  history.join_since(0, joint, false);
  EXPECT_EQ(history.count(MonoState::scale_uncertain), 1U);
}

TEST(PoseHistory, ForgetsFromATimestampOn) {
  vo::PoseHistory history;
  for (const double timestamp : {0.0, 1.0, 2.0}) {
    history.add(timestamp, SE3(), MonoState::orienting);
  }
  EXPECT_FALSE(history.has_pose_in_map());
  history.forget_since(1);
  ASSERT_EQ(history.size(), 1U);
  EXPECT_EQ(history.trajectory().back().timestamp, 0);
}

}  // namespace
