#include "synth/path/recorded_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/pose_near.h"

namespace synth {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using support::error_text;
using support::PoseNear;
using testing::HasSubstr;

constexpr support::PoseTolerance kSameRecordedPose{.translation_m = 1e-12, .rotation_deg = 1e-6};

TEST(Placed, LeavesARecordingAsItIsByDefault) {
  const vo::Trajectory recording = {{5, {Quaterniond(0.5, 0.5, -0.5, 0.5), {1, 2, 3}}}};
  const vo::Trajectory result = placed(recording, {});
  EXPECT_EQ(result[0].timestamp, 5);
  EXPECT_THAT(result[0].T_world_camera, PoseNear(recording[0].T_world_camera, kSameRecordedPose));
}

/// z up becomes y up: x stays, y goes into the picture. Then a quarter turn takes x to -z.
TEST(Placed, TurnsZUpwardsScalesTurnsAndMoves) {
  const vo::Trajectory recording = {{0, {Quaterniond::Identity(), {1, 2, 3}}}};
  const Vector3d upright = placed(recording, {.up = UpAxis::z})[0].T_world_camera.translation();
  EXPECT_LT((upright - Vector3d(1, 3, -2)).norm(), 1e-12);
  const vo::SE3 all =
      placed(recording, {.up = UpAxis::z, .scale = 2, .turn_deg = 90, .by = {10, 0, 0}})[0]
          .T_world_camera;
  EXPECT_LT((all.translation() - Vector3d(10 - 4, 6, -2)).norm(), 1e-12);
  EXPECT_LT((all.rotation() * Vector3d::UnitZ() - Vector3d::UnitY()).norm(), 1e-12);
}

TEST(Placed, TakesABodysPosesToItsCamera) {
  const vo::SE3 T_world_body(Quaterniond(0.5, 0.5, 0.5, 0.5), {1, 2, 3});
  const vo::SE3 T_body_camera(Quaterniond(0.6, 0, 0, 0.8), {0.1, 0, 0.2});
  EXPECT_THAT(
      placed({{0, T_world_body}}, {.body_camera = "0.1,0,0.2,0,0,0.8,0.6"})[0].T_world_camera,
      PoseNear(T_world_body * T_body_camera, kSameRecordedPose));
}

TEST(Placed, NeedsAScaleAndARotation) {
  EXPECT_THAT(error_text([] { placed({}, {.scale = 0}); }), HasSubstr("expected above 0, got 0"));
  EXPECT_THAT(error_text([] { placed({}, {.body_camera = "0,0,0,0,0,0,3"}); }),
              HasSubstr("expected a quaternion of length 1, got length 3"));
}

}  // namespace
}  // namespace synth
