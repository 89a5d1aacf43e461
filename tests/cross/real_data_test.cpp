#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tools/studies/alterations.h"
#include "tools/studies/clip.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/sequence.h"
#include "vo/evaluation/evaluate.h"
#include "vo/odometry/mono_odometry.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/sequence_odometry/track_mono.h"

namespace {

/// Returns the real clip as an alteration makes it; nothing where there is no such data.
std::optional<tools::Clip> altered_clip(const std::string& alteration) {
  const std::filesystem::path folder = std::filesystem::path(EDVO_SHARED_DATA) / "tum_fr1_xyz";
  if (!std::filesystem::exists(folder)) {
    return {};
  }
  const vo::SequenceReader sequence(folder, vo::load_camera("tum-fr1"));
  return tools::altered(tools::load_clip(sequence, "clip", 0, [](std::size_t, std::size_t) {}),
                        alteration);
}

/// An independent implementation of the paper, frame to frame, measured 0.0319 m and 0.0440 m on
/// this clip (on the whole sequence 0.0276 m, where the paper prints 0.0277 m).
TEST(RealData, ThePaperPresetReproducesThePapersAccuracy) {
  const std::filesystem::path clip = std::filesystem::path(EDVO_SHARED_DATA) / "tum_fr1_xyz";
  if (!std::filesystem::exists(clip)) {
    GTEST_SKIP() << "no TUM data at " << clip;
  }
  const vo::SequenceReader sequence(clip, vo::load_camera("tum-fr1"));
  vo::RgbdOdometry odometry(sequence.camera().pinhole,
                            vo::preset_options(vo::TrackerPreset::paper));
  vo::FrameStream stream(sequence);
  while (const auto frame = stream.next()) {
    EXPECT_NE(odometry.track(*frame).status, vo::TrackingStatus::lost) << frame->timestamp;
  }
  const vo::TrajectoryErrors errors = vo::evaluate(sequence.ground_truth(), odometry.trajectory());
  EXPECT_NEAR(errors.rpe.translation.rmse, 0.0319, 0.08 * 0.0319);
  EXPECT_NEAR(errors.ate.rmse, 0.0440, 0.20 * 0.0440);
}

/// The clip seen otherwise by the default tracker. Bounds are at most 15 % above what was measured
/// (docs/results.md).
struct AlteredClip {
  const char* alteration;
  double max_rpe_mm;
  double max_ate_mm;
};

class DefaultPreset : public testing::TestWithParam<AlteredClip> {};

TEST_P(DefaultPreset, KeepsItsAccuracyInOtherCircumstances) {
  const std::optional<tools::Clip> found = altered_clip(GetParam().alteration);
  if (!found) {
    GTEST_SKIP() << "no TUM data beside the repository";
  }
  const tools::ClipScore score =
      tools::score(*found, vo::preset_options(vo::TrackerPreset::best_measured));
  EXPECT_EQ(score.tracked_percent, 100);
  EXPECT_LE(score.rpe_mm, GetParam().max_rpe_mm);
  EXPECT_LE(score.ate_mm, GetParam().max_ate_mm);
}

INSTANTIATE_TEST_SUITE_P(
    RealData, DefaultPreset,
    testing::Values(AlteredClip{"none", 8.6, 5.2}, AlteredClip{"reversed", 10.8, 5.9},
                    AlteredClip{"turned_90", 9.0, 5.1}, AlteredClip{"turned_180", 8.6, 5.0},
                    AlteredClip{"turned_270", 9.0, 5.3}, AlteredClip{"every_third", 12.7, 8.3},
                    AlteredClip{"half_size", 9.8, 5.4}, AlteredClip{"flicker", 8.6, 5.1},
                    AlteredClip{"patch_25", 12.3, 7.8}),
    [](const auto& altered) { return std::string(altered.param.alteration); });

/// Sixty frames repeat one image while the camera goes on.
TEST(RealData, FrozenImagesAreUncertainAndNoOtherPoseIsWrong) {
  const std::optional<tools::Clip> found = altered_clip("frozen");
  if (!found) {
    GTEST_SKIP() << "no TUM data beside the repository";
  }
  const tools::Clip& clip = *found;
  vo::RgbdOdometry odometry(clip.camera);
  vo::Trajectory sure;
  int repeated = 0;
  for (const vo::RgbdFrame& frame : clip.frames) {
    const vo::TrackingResult result = odometry.track(frame);
    repeated += result.reason == vo::TrackingReason::image_repeated ? 1 : 0;
    if (result.status == vo::TrackingStatus::tracked) {
      sure.push_back({frame.timestamp, result.T_world_camera});
    }
  }
  EXPECT_EQ(repeated, 59);
  EXPECT_LT(tools::errors_of(clip.truth, sure).worst_mm, 30);
}

/// A patch that slides over 70 % of the view takes the camera with it. Nothing says which of the
/// two motions is the world's, so no pose may be sure once it is wrong.
TEST(RealData, NoPoseIsWrongAndSureWhereMostOfTheViewMoves) {
  const std::optional<tools::Clip> found = altered_clip("patch_70");
  if (!found) {
    GTEST_SKIP() << "no TUM data beside the repository";
  }
  const tools::Clip& clip = *found;
  vo::RgbdOdometry odometry(clip.camera);
  const std::optional<vo::SE3> T_truth_first =
      vo::pose_at(clip.truth, clip.frames.front().timestamp);
  ASSERT_TRUE(T_truth_first);
  std::size_t doubted = 0;
  for (const vo::RgbdFrame& frame : clip.frames) {
    const vo::TrackingResult result = odometry.track(frame);
    const std::optional<vo::SE3> T_truth_camera = vo::pose_at(clip.truth, frame.timestamp);
    doubted += result.reason == vo::TrackingReason::two_motions ? 1 : 0;
    if (T_truth_camera && result.status == vo::TrackingStatus::tracked) {
      const vo::SE3 T_error = T_truth_camera->inverse() * *T_truth_first * result.T_world_camera;
      EXPECT_LT(T_error.translation().norm(), 0.05) << frame.timestamp;
    }
  }
  EXPECT_GT(doubted, clip.frames.size() * 9 / 10);
}

struct MonocularStart {
  vo::MonoBootstrap bootstrap;
  double max_ate;  ///< m, after Sim(3) alignment
};

/// Grey images alone but for what the start asks for; LSD-SLAM and ORB-SLAM err by 10 to 15 mm.
class MonocularClip : public testing::TestWithParam<MonocularStart> {};

TEST_P(MonocularClip, IsFollowedFromItsStartToItsEnd) {
  const std::filesystem::path clip = std::filesystem::path(EDVO_SHARED_DATA) / "tum_fr1_xyz";
  if (!std::filesystem::exists(clip)) {
    GTEST_SKIP() << "no TUM data at " << clip;
  }
  vo::MonoOptions options = vo::mono_options();
  options.bootstrap = GetParam().bootstrap;
  const vo::MonoSequenceResult result =
      vo::track_mono_sequence({clip, vo::load_camera("tum-fr1")}, options,
                              /*observe=*/{}, [](std::size_t, std::size_t) {});
  EXPECT_EQ(result.trajectory.size(), result.frames.size());
  const vo::TrajectoryErrors errors =
      vo::evaluate(vo::SequenceReader(clip, vo::load_camera("tum-fr1")).ground_truth(),
                   result.trajectory, {.alignment = vo::TrajectoryAlignment::sim3});
  EXPECT_LE(errors.ate.rmse, GetParam().max_ate);
}

INSTANTIATE_TEST_SUITE_P(RealData, MonocularClip,
                         testing::Values(MonocularStart{vo::MonoBootstrap::rgbd, 0.008},
                                         MonocularStart{vo::MonoBootstrap::automatic, 0.012}),
                         [](const auto& start) {
                           return std::string(vo::to_string(start.param.bootstrap));
                         });

}  // namespace
