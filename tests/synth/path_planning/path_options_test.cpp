#include "synth/path_planning/path_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/pose_near.h"
#include "tests/support/temp_folder.h"
#include "vo/files/output.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

using support::PoseNear;
using support::TempFolder;
using synth::PathKind;

const synth::SceneFile kNoScene;  // none of these paths looks at it
constexpr support::PoseTolerance kFilePrecision{.translation_m = 1e-8, .rotation_deg = 1e-6};

constexpr support::PoseTolerance kNearAStraightLine{.translation_m = 1e-2, .rotation_deg = 1};

TEST(PathOptions, ATrajectoryIsTakenAsItIs) {
  const TempFolder folder;
  const vo::Trajectory truth = support::example_trajectory(7, 10, 5.0);
  const auto file = folder.write("t.txt", vo::format_trajectory(truth));
  const vo::Trajectory path =
      synth::make_trajectory({.kind = synth::PathKind::trajectory, .file = file}, kNoScene);
  ASSERT_EQ(path.size(), truth.size());
  EXPECT_THAT(path[3].T_world_camera, PoseNear(truth[3].T_world_camera, kFilePrecision));
}

TEST(PathOptions, ATrajectoryIsReadInAnyFormat) {
  const TempFolder folder;
  const vo::Trajectory truth = support::example_trajectory(7, 10, 5.0);
  const auto file = folder.write("poses.txt", vo::format_kitti_poses(truth));
  const auto times = folder.write("times.txt", vo::format_kitti_times(truth));
  synth::PathOptions options{.kind = synth::PathKind::trajectory, .file = file};
  options.file_times = times;
  for (const char* format : {"", "kitti"}) {
    options.file_format = format;
    const vo::Trajectory path = synth::make_trajectory(options, kNoScene);
    ASSERT_EQ(path.size(), truth.size());
    EXPECT_NEAR(path[3].timestamp, truth[3].timestamp, 1e-9);
    EXPECT_THAT(path[3].T_world_camera, PoseNear(truth[3].T_world_camera, kFilePrecision));
  }
  options.file_format = "kiti";
  EXPECT_THAT(support::error_text([&] { options.validate(); }),
              testing::HasSubstr("path.file_format: expected one of tum, euroc, kitti"));
}

TEST(PathOptions, ASplineOfAFileRunsThroughItsPosesAtTheirTimes) {
  const TempFolder folder;
  const vo::Trajectory keys = support::example_trajectory(5, 2, 100.0);
  const auto file = folder.write("t.txt", vo::format_trajectory(keys));
  const vo::Trajectory path =
      synth::make_trajectory({.kind = synth::PathKind::spline, .rate = 20, .file = file}, kNoScene);
  ASSERT_EQ(path.size(), 41U) << "two seconds at 20 Hz, both ends";
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_NEAR(path[10 * i].timestamp, keys[i].timestamp, 1e-6);
    EXPECT_THAT(path[10 * i].T_world_camera, PoseNear(keys[i].T_world_camera, kFilePrecision));
  }
}

TEST(PathOptions, ASplineOfEyesLooksAtItsTargets) {
  const synth::PathOptions options{.kind = synth::PathKind::spline,
                                   .rate = 10,
                                   .duration = 2,
                                   .eyes = {{0, 1, 2}, {1, 1, 2}, {1, 1.5, 1}},
                                   .targets = {{0, 1, 0}, {0, 1, 0}, {0.5, 1, -1}}};
  const vo::Trajectory path = synth::make_trajectory(options, kNoScene);
  ASSERT_EQ(path.size(), 21U);
  for (std::size_t i = 0; i < options.eyes.size(); ++i) {
    const vo::SE3& T_world_camera = path[10 * i].T_world_camera;
    EXPECT_LT((T_world_camera.translation() - options.eyes[i]).norm(), 1e-9);
    const Eigen::Vector3d target = T_world_camera.inverse() * options.targets[i];
    EXPECT_LT(target.head<2>().norm(), 1e-9) << "in the middle of the image";
  }
}

TEST(PathOptions, ARecordingIsPutIntoTheSceneAndResampled) {
  const TempFolder folder;
  const vo::Trajectory keys = support::example_trajectory(5, 2, 100.0);
  const auto file = folder.write("t.txt", vo::format_trajectory(keys));
  const vo::Trajectory path = synth::make_trajectory(
      {.kind = synth::PathKind::recorded, .rate = 20, .file = file, .recorded = {.by = {0, 0, 5}}},
      kNoScene);
  ASSERT_EQ(path.size(), 41U);
  const vo::SE3& key = keys[2].T_world_camera;
  EXPECT_THAT(path[20].T_world_camera,
              PoseNear(vo::SE3(key.rotation(), key.translation() + Eigen::Vector3d(0, 0, 5)),
                       kFilePrecision));
}

TEST(PathOptions, AHandShakesAnyPath) {
  synth::PathOptions options{.kind = synth::PathKind::still, .rate = 10, .duration = 1};
  const vo::Trajectory steady = synth::make_trajectory(options, kNoScene);
  options.shake.amplitude = 0.01;
  const vo::Trajectory shaken = synth::make_trajectory(options, kNoScene);
  ASSERT_EQ(shaken.size(), 11U);
  EXPECT_EQ(vo::path_length(steady), 0);
  EXPECT_GT(vo::path_length(shaken), 0.01);
}

TEST(PathOptions, APathCanBeAskedBetweenItsFrames) {
  const TempFolder folder;
  const vo::Trajectory truth = support::example_trajectory(7, 10, 5.0);
  const auto file = folder.write("t.txt", vo::format_trajectory(truth));
  const synth::TimedPath timed =
      synth::make_path({.kind = synth::PathKind::trajectory, .file = file}, kNoScene);
  const double between = (timed.times[2] + timed.times[3]) / 2;
  const vo::SE3 halfway = *vo::pose_at(truth, between);
  EXPECT_THAT(timed.path(between), PoseNear(halfway, kNearAStraightLine));
}

}  // namespace
