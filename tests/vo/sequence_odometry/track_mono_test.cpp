#include "vo/sequence_odometry/track_mono.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"
#include "tests/support/sideways_walk.h"

namespace {

/// The frames before the last are told of when nobody knew where they were.
TEST(TrackMono, ASequenceThatEndsWhileTheStartWaitsHasPosesAllTheSame) {
  int next = 0;
  const vo::MonoImages images{.camera = support::small_camera(),
                              .size = support::kShortWalk,
                              .next = [&]() -> std::optional<vo::RgbdFrame> {
                                if (next == support::kShortWalk) {
                                  return std::nullopt;
                                }
                                const int i = next++;
                                return support::plane_frame(support::small_camera(),
                                                            support::sideways_walk(i), i);
                              }};
  std::vector<vo::MonoState> told;
  const vo::MonoSequenceResult result = vo::track_mono_images(
      images, vo::mono_options(),
      [&](const vo::RgbdFrame&, const vo::MonoOdometry&, const vo::MonoResult& frame) {
        told.push_back(frame.state);
      },
      [](std::size_t, std::size_t) {});
  ASSERT_EQ(result.frames.size(), std::size_t{support::kShortWalk});
  EXPECT_EQ(result.tracking().tracked_fraction(), 1);
  EXPECT_EQ(result.frames.back().state, vo::MonoState::tracking);
  EXPECT_EQ(result.frames[result.frames.size() - 2].state, vo::MonoState::initialising);
  ASSERT_EQ(told.size(), result.frames.size());
  EXPECT_EQ(told.back(), vo::MonoState::tracking);
}

TEST(TrackMono, ARunWithoutAPoseSaysWhy) {
  int next = 0;
  const vo::MonoImages images{
      .camera = support::small_camera(), .size = 4, .next = [&]() -> std::optional<vo::RgbdFrame> {
        const int i = next++;
        return i < 4 ? std::optional(support::plane_frame(support::small_camera(), vo::SE3(), i))
                     : std::nullopt;
      }};
  const vo::MonoSequenceResult result =
      vo::track_mono_images(images, vo::mono_options(), {}, [](std::size_t, std::size_t) {});
  EXPECT_TRUE(result.trajectory.empty());
  EXPECT_THAT(result.why_no_pose(),
              testing::StartsWith("no frame has a pose: waiting 4, the largest parallax"));
}

}  // namespace
