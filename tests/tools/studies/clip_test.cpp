#include "tools/studies/clip.h"

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/gltf/gltf.h"
#include "synth/rendering/renderer.h"
#include "tests/support/error_text.h"
#include "tests/support/plane_sequence.h"
#include "tests/support/temp_folder.h"
#include "tools/studies/pose_pairs.h"
#include "tools/studies/study.h"

namespace {

using support::TempFolder;

tools::Clip plane_clip(int frames, std::size_t max_frames = 0) {
  const TempFolder folder;
  support::write_plane_sequence(folder.path(), frames);
  return tools::load_clip(vo::SequenceReader(folder.path()), "plane", max_frames,
                          [](std::size_t, std::size_t) {});
}

vo::SE3 moved_right(double x) {
  return {Eigen::Quaterniond::Identity(), {x, 0, 0}};
}

TEST(AblateClip, HoldsTheFirstFrames) {
  EXPECT_EQ(plane_clip(4).frames.size(), 4U);
  EXPECT_EQ(plane_clip(4, 3).frames.size(), 3U);
  EXPECT_EQ(plane_clip(4, 9).frames.size(), 4U);
}

TEST(AblateClip, PairsAreTheDistanceApartAndKnowTheTruth) {
  const tools::Clip clip = plane_clip(9);
  const std::vector<tools::FramePair> pairs = tools::pairs_apart(clip, 2, 3);
  ASSERT_EQ(pairs.size(), 3U);
  for (const tools::FramePair& pair : pairs) {
    EXPECT_EQ(pair.cur - pair.ref, 2U);
    EXPECT_NEAR(pair.T_cur_ref.translation().x(), -2 * 0.005, 1e-6) << "5 mm a frame";
  }
  EXPECT_EQ(tools::pairs_apart(clip, 2, 100).size(), 7U);
  EXPECT_TRUE(tools::pairs_apart(clip, 9, 100).empty());
}

TEST(AblateClip, ScoreOfAClipIsSmallWhereTrackingIsExact) {
  const tools::ClipScore score = tools::score(plane_clip(10), {});
  EXPECT_LT(score.rpe_mm, 2) << "of 23 mm";
  EXPECT_LT(score.ate_mm, 2);
  EXPECT_EQ(score.tracked_percent, 100);
  EXPECT_GT(score.points, 100);
}

TEST(MeanFlow, OfAPlaneInFrontIsFocalLengthTimesShiftOverDepth) {
  const auto camera = vo::PinholeCamera::from_horizontal_fov(64, 48, 60);
  const vo::DepthImage depth(48, 64, 2.0F);
  EXPECT_NEAR(tools::mean_flow_px(depth, camera, moved_right(-0.1), 1), camera.fx * 0.1 / 2, 1e-9);
  EXPECT_NEAR(tools::mean_flow_px(depth, camera, moved_right(-0.1), 4), camera.fx * 0.1 / 2, 1e-9);
  EXPECT_EQ(tools::mean_flow_px(vo::DepthImage(48, 64, 0.0F), camera, moved_right(1), 1), 0);
}

TEST(PoseError, IsInMillimetresAndDegrees) {
  vo::Vector6d twist;
  twist << 0, 0, 0, 0, std::numbers::pi / 180, 0;
  const tools::PoseError error =
      tools::pose_error(moved_right(1), moved_right(1.002) * vo::SE3::exp(twist));
  EXPECT_NEAR(error.mm, 2, 1e-9);
  EXPECT_NEAR(error.deg, 1, 1e-9);
}

TEST(StudySettings, WhatVariesGoesBeforeWhatTheUserSetsAndThatBeforeWhatIsHeld) {
  const tools::StudySettings settings{
      .assignments = {{"keyframes.every", "7"}, {"pyramid.levels", "4"}}};
  const vo::TrackerOptions options = settings.options(
      {{"keyframes.every", "2"}, {"points.fraction", "0.5"}}, {{"pyramid.levels", "5"}});
  EXPECT_EQ(options.points.fraction, 0.5);
  EXPECT_EQ(options.keyframes.every, 7);
  EXPECT_EQ(options.pyramid.levels, 5);
  EXPECT_EQ(settings.described(), "preset paper with keyframes.every=7, pyramid.levels=4");
  EXPECT_THAT(support::error_text([&] {
                settings.options({}, {{"points.fractoin", "1"}});
              }),
              testing::HasSubstr("points.fraction"));
}

synth::Scene room() {
  return synth::load_gltf(std::string(EDVO_SOURCE_DIR) + "/assets/room/room.gltf");
}

TEST(PosePairs, MoveTheImageByTheFlowTheyPromise) {
  const auto camera = vo::PinholeCamera::from_horizontal_fov(640, 480, 62);
  const tools::PosePairOptions options{.views = 3};
  const synth::Scene scene = room();
  const vo::Trajectory poses = tools::pose_pairs(scene, camera, options);
  ASSERT_EQ(poses.size(), 3U * 5);
  const auto renderer = synth::make_renderer(scene, {.samples = 1});
  const vo::PinholeCamera oracle_camera = camera.halved();
  for (std::size_t first = 0; first < poses.size(); first += 5) {
    const vo::SE3& T_world_ref = poses[first].T_world_camera;
    const vo::DepthImage depth = renderer->render(oracle_camera, T_world_ref).depth;
    for (std::size_t i = 1; i < 5; ++i) {
      double flow = 0;  // px of the full image, through world coordinates
      for (int v = 0; v < depth.rows; ++v) {
        for (int u = 0; u < depth.cols; ++u) {
          const Eigen::Vector3d p_world =
              T_world_ref * oracle_camera.unproject(Eigen::Vector2d(u, v), depth(v, u));
          const Eigen::Vector2d pixel =
              oracle_camera.project(poses[first + i].T_world_camera.inverse() * p_world);
          flow += 2 * (pixel - Eigen::Vector2d(u, v)).norm() / static_cast<double>(depth.total());
        }
      }
      const double promised = options.flows_px[i - 1];
      EXPECT_NEAR(flow, promised, 0.03 * promised) << "planned on an eighth of the resolution";
    }
  }
}

TEST(PosePairs, DependOnTheSeedAlone) {
  const auto camera = vo::PinholeCamera::from_horizontal_fov(160, 120, 62);
  const synth::Scene scene = room();
  const auto first_eye = [&](std::uint64_t seed) {
    return tools::pose_pairs(scene, camera, {.views = 1, .seed = seed})[0]
        .T_world_camera.translation();
  };
  EXPECT_EQ(first_eye(1), first_eye(1));
  EXPECT_NE(first_eye(1), first_eye(2));
}

}  // namespace
