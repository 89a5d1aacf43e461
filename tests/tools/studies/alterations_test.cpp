#include "tools/studies/alterations.h"

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/textured_plane.h"

namespace {

using testing::HasSubstr;
using tools::altered;
using tools::Clip;

/// A camera off its image's centre, with a lens of every coefficient, that swings past the plane.
Clip swinging_clip(int frames) {
  Clip clip{.name = "plane", .camera = {96, 64, 80, 84, 50, 29, {0.02, 0.01, 0.004, -0.003, 0}}};
  for (int i = 0; i < frames; ++i) {
    const double t = i / 30.0;
    const vo::SE3 T_world_camera =
        vo::SE3::exp((vo::Vector6d() << 0.3 * t, 0.1 * t, 0.02, 0.05, 0.2 * t, 0.3 * t).finished());
    clip.truth.push_back({t, T_world_camera});
    clip.frames.push_back(support::TexturedPlane().render(clip.camera, T_world_camera, t));
  }
  return clip;
}

/// Returns the greatest difference between a clip's depth and that of the plane from its own truth
/// through its own camera, m.
double depth_error(const Clip& clip) {
  double greatest = 0;
  for (const vo::RgbdFrame& frame : clip.frames) {
    const auto T_world_camera = vo::pose_at(clip.truth, frame.timestamp);
    EXPECT_TRUE(T_world_camera.has_value());
    for (int v = 0; v < frame.depth.rows; v += 7) {
      for (int u = 0; u < frame.depth.cols; u += 7) {
        const double z = support::TexturedPlane().depth(clip.camera, *T_world_camera, {u, v});
        greatest = std::max(greatest, std::abs(z - frame.depth(v, u)));
      }
    }
  }
  return greatest;
}

TEST(Alterations, TurnedOrReversedImagesAreThoseOfTheAlteredCameraAndTruth) {
  const Clip clip = swinging_clip(5);
  for (const char* name :
       {"none", "reversed", "turned_90", "turned_180", "turned_270", "every_third"}) {
    const Clip changed = altered(clip, name);
    EXPECT_LT(depth_error(changed), 1e-5) << name;
    EXPECT_EQ(changed.frames.front().image.cols, changed.camera.width) << name;
  }
}

TEST(Alterations, DepthBeforeTheImageIsAfterItInAReversedClip) {
  Clip clip = swinging_clip(3);
  clip.frames[1].depth_delay = -0.008;
  EXPECT_EQ(altered(clip, "reversed").frames[1].depth_delay, 0.008);
  EXPECT_EQ(altered(clip, "turned_90").frames[1].depth_delay, -0.008);
}

/// The altered clip keeps the nearest of each four depths, which is off the middle by half a pixel
/// of the plane's slope.
TEST(Alterations, HalfSizeIsThatOfTheHalvedCamera) {
  EXPECT_LT(depth_error(altered(swinging_clip(2), "half_size")), 0.03);
}

TEST(Alterations, FaultsChangeWhatTheySayAndLeaveTheRecordedClipAlone) {
  const Clip clip = swinging_clip(12);
  const cv::Mat before = clip.frames[5].image.clone();
  const Clip black = altered(clip, "half_black");
  EXPECT_EQ(cv::countNonZero(black.frames[5].image.colRange(0, 48)), 0);
  EXPECT_EQ(cv::norm(black.frames[5].image.colRange(48, 96), before.colRange(48, 96)), 0);
  EXPECT_EQ(cv::norm(clip.frames[5].image, before), 0);
  const Clip stuck = altered(clip, "stuck_part");
  EXPECT_EQ(cv::norm(stuck.frames[5].image.rowRange(43, 64), clip.frames[0].image.rowRange(43, 64)),
            0);
  const Clip frozen = altered(clip, "frozen");
  EXPECT_EQ(cv::norm(frozen.frames[11].image, clip.frames[6].image), 0);
  const Clip fifth = altered(clip, "depth_fifth");
  EXPECT_FLOAT_EQ(fifth.frames[3].depth(20, 20), clip.frames[3].depth(20, 20) / 5);
  const Clip stale = altered(clip, "depth_stale");
  EXPECT_EQ(cv::norm(stale.frames[11].depth, clip.frames[1].depth), 0);
  const Clip patch = altered(clip, "patch_25");
  const cv::Mat covered = patch.frames[4].depth == 0.6F;
  EXPECT_EQ(cv::countNonZero(covered), 48 * 32) << "a quarter of the pixels";
}

TEST(Alterations, StripesBendDepthBySixPercentAtMostAndWander) {
  const Clip clip = swinging_clip(12);
  const Clip striped = altered(clip, "depth_striped");
  const cv::Mat first = striped.frames[0].depth / clip.frames[0].depth;
  const cv::Mat later = striped.frames[10].depth / clip.frames[10].depth;
  double least = 0;
  double greatest = 0;
  cv::minMaxLoc(first, &least, &greatest);
  const double most = 0.06 * std::sin(std::numbers::pi / 3);  // a stripe is 6 px wide
  EXPECT_NEAR(least, 1 - most, 1e-5);
  EXPECT_NEAR(greatest, 1 + most, 1e-5);
  EXPECT_LT(cv::norm(first + later - 2, cv::NORM_INF), 1e-5) << "half a period later";
}

TEST(Alterations, AFenceStaysInTheImageAndLeavesDepthAlone) {
  const Clip clip = swinging_clip(3);
  const Clip fenced = altered(clip, "fence");
  EXPECT_EQ(cv::norm(fenced.frames[2].depth, clip.frames[2].depth), 0);
  const cv::Mat wires = fenced.frames[2].image == 20;
  EXPECT_GE(cv::countNonZero(wires), 12 * 64 + 8 * 96 - 12 * 8);
  EXPECT_EQ(cv::countNonZero((fenced.frames[2].image != clip.frames[2].image) & ~wires), 0);
}

TEST(Alterations, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const tools::Alteration& alteration : tools::alterations()) {
    EXPECT_TRUE(names.insert(alteration.name).second) << alteration.name;
    EXPECT_FALSE(alteration.description.empty()) << alteration.name;
  }
  EXPECT_THAT(support::error_text([] { altered({}, "upside_down"); }), HasSubstr("upside_down"));
}

}  // namespace
