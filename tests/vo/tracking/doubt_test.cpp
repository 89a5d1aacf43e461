#include "vo/tracking/doubt.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"
#include "vo/odometry/rgbd_odometry.h"

namespace {

using support::plane_frame;
using support::small_camera;
using support::sway;
using vo::TrackingReason;
using vo::TrackingStatus;

vo::FramePyramid frame_of(std::uint64_t image, std::uint64_t depth) {
  vo::FramePyramid frame;
  frame.image_fingerprint = image;
  frame.depth_fingerprint = depth;
  return frame;
}

vo::AlignResult agreeing_but(double disagreeing_fraction) {
  vo::AlignResult alignment;
  alignment.agreement.disagreeing_fraction = disagreeing_fraction;
  return alignment;
}

TrackingReason judged(vo::Doubt& doubt, const vo::FramePyramid& frame, double disagreeing) {
  doubt.see(frame);
  return doubt.judge(agreeing_but(disagreeing), {});
}

TEST(Doubt, OfAnImageThatIsRepeated) {
  vo::Doubt doubt;
  EXPECT_EQ(judged(doubt, frame_of(1, 11), 0), TrackingReason::none);
  EXPECT_EQ(judged(doubt, frame_of(1, 11), 0), TrackingReason::image_repeated);
  EXPECT_EQ(judged(doubt, frame_of(2, 12), 0), TrackingReason::none);
}

TEST(Doubt, OfADepthThatStandsStillLongerThanThatOfASlowSensor) {
  vo::Doubt doubt;
  for (std::uint64_t i = 1; i <= 6; ++i) {
    EXPECT_EQ(judged(doubt, frame_of(i, 11), 0), TrackingReason::none) << i;
  }
  EXPECT_EQ(judged(doubt, frame_of(7, 11), 0), TrackingReason::depth_repeated);
  EXPECT_EQ(judged(doubt, frame_of(8, 12), 0), TrackingReason::none);
  for (std::uint64_t i = 9; i < 30; ++i) {
    EXPECT_EQ(judged(doubt, frame_of(i, 0), 0), TrackingReason::none) << "no depth at all";
  }
}

TEST(Doubt, OfPartsThatDisagreeMuchAtOnceOrALittleForLong) {
  vo::Doubt at_once;
  EXPECT_EQ(judged(at_once, frame_of(1, 1), 0.2), TrackingReason::parts_disagree);
  EXPECT_EQ(judged(at_once, frame_of(2, 2), 0), TrackingReason::none);

  vo::Doubt for_long;
  std::uint64_t frame = 1;
  for (; frame < 5; ++frame) {
    EXPECT_EQ(judged(for_long, frame_of(frame, frame), 0.1), TrackingReason::none) << frame;
  }
  for (; frame < 20; ++frame) {
    for_long.see(frame_of(frame, frame));
    for_long.judge(agreeing_but(0.1), {});
  }
  EXPECT_EQ(judged(for_long, frame_of(20, 20), 0.05), TrackingReason::parts_disagree);
}

TrackingReason judged_with_noise(vo::Doubt& doubt, double noise_share) {
  return doubt.judge({.noise_share = noise_share}, {});
}

TEST(Doubt, OfAMotionAlongWhichImagesShareNothingAtOnceOrLittleForLong) {
  vo::Doubt at_once;
  EXPECT_EQ(judged_with_noise(at_once, 0.95), TrackingReason::undetermined);
  EXPECT_EQ(judged_with_noise(at_once, 0.3), TrackingReason::none);

  vo::Doubt for_long;
  EXPECT_EQ(judged_with_noise(for_long, 0.8), TrackingReason::none);
  for (int i = 0; i < 10; ++i) {
    judged_with_noise(for_long, 0.8);
  }
  EXPECT_EQ(judged_with_noise(for_long, 0.8), TrackingReason::undetermined);
  EXPECT_EQ(judged_with_noise(for_long, 0.3), TrackingReason::undetermined);
  judged_with_noise(for_long, 0.3);
  EXPECT_EQ(judged_with_noise(for_long, 0.3), TrackingReason::none);
}

TEST(Doubt, OfAPositionWhoseDeviationIsAHundredthOfTheDepth) {
  vo::Doubt doubt;
  vo::AlignResult alignment;
  alignment.mean_depth = 2;
  const double per_axis_m = 0.02 / std::sqrt(3.0);
  alignment.covariance.diagonal().head<3>().setConstant(std::pow(0.99 * per_axis_m, 2));
  EXPECT_EQ(doubt.judge(alignment, {}), TrackingReason::none);
  alignment.covariance.diagonal().head<3>().setConstant(std::pow(1.01 * per_axis_m, 2));
  EXPECT_EQ(doubt.judge(alignment, {}), TrackingReason::undetermined);
  alignment.mean_depth = 3;
  EXPECT_EQ(doubt.judge(alignment, {}), TrackingReason::none) << "farther away";
}

TEST(Doubt, OfDepthsThatDifferFromTheReferencesMuchAtOnceOrALittleForLong) {
  vo::Doubt at_once;
  EXPECT_EQ(at_once.judge({}, {.depth_deviation = 0.05}), TrackingReason::depths_disagree);
  EXPECT_EQ(at_once.judge({}, {.depth_deviation = 0}), TrackingReason::none);

  vo::Doubt for_long;
  EXPECT_EQ(for_long.judge({}, {.depth_deviation = 0.025}), TrackingReason::none);
  for (int i = 0; i < 10; ++i) {
    for_long.judge({}, {.depth_deviation = 0.025});
  }
  EXPECT_EQ(for_long.judge({}, {.depth_deviation = 0.025}), TrackingReason::depths_disagree);
}

TEST(Doubt, OfAViewThatIsCovered) {
  vo::Doubt doubt;
  EXPECT_EQ(doubt.judge({}, {.edged = {}, .covered_fraction = 0.25}), TrackingReason::none);
  EXPECT_EQ(doubt.judge({}, {.edged = {}, .covered_fraction = 0.35}), TrackingReason::view_covered);
}

/// Returns what is made of the last one of so many frames that show these surfaces.
TrackingReason after(int frames, const vo::SurfaceAreas& areas, vo::Doubt& doubt) {
  TrackingReason reason = TrackingReason::none;
  for (int i = 0; i < frames; ++i) {
    reason = doubt.judge({}, {.edged = areas, .covered_fraction = 0});
  }
  return reason;
}

TEST(Doubt, OfMotionsThatCompeteAtOnceOrForLong) {
  vo::Doubt doubt;
  EXPECT_EQ(after(20, {.of_static = 10, .of_moving = 3}, doubt), TrackingReason::none);
  EXPECT_EQ(after(1, {.of_static = 10, .of_moving = 6}, doubt), TrackingReason::two_motions);
  EXPECT_EQ(after(1, {.of_static = 10, .of_moving = 3}, doubt), TrackingReason::none);
  EXPECT_EQ(after(20, {.of_static = 10, .of_moving = 5}, doubt), TrackingReason::two_motions);
}

TEST(Doubt, OfTheFrameInWhichAnotherMotionIsFoundToBeTheCameras) {
  vo::Doubt doubt;
  EXPECT_EQ(doubt.judge({}, {.changed_motion = true}), TrackingReason::two_motions);
  EXPECT_EQ(doubt.judge({}, {.changed_motion = false}), TrackingReason::none);
}

TEST(Doubt, OfTheFirstFramesIfMotionsCompeteInThem) {
  vo::Doubt doubt;
  EXPECT_EQ(after(1, {.of_static = 10, .of_moving = 5}, doubt), TrackingReason::two_motions);
}

/// The pose may have followed the wrong one, whose rival has left the keyframes or the view.
TEST(Doubt, LastsAfterACompetitionUntilFarMoreRestsThanMoved) {
  vo::Doubt doubt;
  after(20, {.of_static = 10, .of_moving = 6}, doubt);
  EXPECT_EQ(after(100, {.of_static = 10, .of_moving = 0}, doubt), TrackingReason::two_motions);
  EXPECT_EQ(after(30, {.of_static = 20, .of_moving = 0}, doubt), TrackingReason::none);
  EXPECT_EQ(after(30, {.of_static = 10, .of_moving = 0}, doubt), TrackingReason::none);
}

/// The images of a plane, but for some that are those of the frame before.
TEST(Doubt, MarksRepeatedImagesAndFindsTheCameraAfterThem) {
  vo::RgbdOdometry odometry(small_camera());
  for (int i = 0; i < 20; ++i) {
    const bool is_repeated = i > 8 && i < 14;
    const vo::TrackingResult result =
        odometry.track(plane_frame(small_camera(), sway(is_repeated ? 8 : i), i));
    if (is_repeated) {
      EXPECT_EQ(result.status, TrackingStatus::uncertain) << i;
      EXPECT_EQ(result.reason, TrackingReason::image_repeated) << i;
    } else {
      EXPECT_EQ(result.status, i == 0 ? TrackingStatus::initialized : TrackingStatus::tracked) << i;
      const vo::SE3 T_error = (sway(0).inverse() * sway(i)).inverse() * result.T_world_camera;
      EXPECT_LT(T_error.translation().norm(), 3e-3) << i;
    }
  }
}

TEST(Doubt, MarksFramesOfWhichAPartIsStuckOrLeavesItOutAndKeepsTheirPosesRight) {
  vo::RgbdOdometry odometry(small_camera());
  const vo::RgbdFrame first = plane_frame(small_camera(), sway(0), 0);
  const cv::Rect stuck(0, 160, 320, 80);
  int noticed = 0;
  for (int i = 0; i < 25; ++i) {
    vo::RgbdFrame frame = plane_frame(small_camera(), sway(i), i);
    frame.image = frame.image.clone();
    frame.depth = frame.depth.clone();
    first.image(stuck).copyTo(frame.image(stuck));
    first.depth(stuck).copyTo(frame.depth(stuck));
    const vo::TrackingResult result = odometry.track(frame);
    noticed += result.status == TrackingStatus::uncertain || result.moving_fraction > 0.2 ? 1 : 0;
    if (result.status == TrackingStatus::tracked) {
      const vo::SE3 T_error = (sway(0).inverse() * sway(i)).inverse() * result.T_world_camera;
      EXPECT_LT(T_error.translation().norm(), 0.02) << i;
    }
  }
  EXPECT_GT(noticed, 15);
}

/// A wall at 2 m of horizontal stripes, with noise of 4 grey levels. Along the stripes it looks the
/// same from everywhere.
vo::RgbdFrame striped_frame(int index) {
  vo::RgbdFrame frame = support::blank_frame(small_camera(), 0, index);
  for (int v = 0; v < frame.image.rows; ++v) {
    frame.image.row(v) = 60 + 40 * (v / 11 % 3);
  }
  return support::with_noise(frame, 4, static_cast<std::uint64_t>(index));
}

TEST(Doubt, MarksFramesWhoseNoiseAloneDeterminesAMotion) {
  vo::RgbdOdometry odometry(small_camera());
  int sure = 0;
  for (int i = 0; i < 20; ++i) {
    const vo::TrackingResult result = odometry.track(striped_frame(i));
    sure += result.status == TrackingStatus::tracked ? 1 : 0;
  }
  EXPECT_LE(sure, 5);
}

TEST(Doubt, DoesNotTakeTextureInTheSameNoiseForNoise) {
  vo::RgbdOdometry odometry(small_camera());
  for (int i = 0; i < 20; ++i) {
    const vo::TrackingResult result = odometry.track(support::with_noise(
        plane_frame(small_camera(), sway(i), i), 4, static_cast<std::uint64_t>(i)));
    EXPECT_EQ(result.status, i == 0 ? TrackingStatus::initialized : TrackingStatus::tracked) << i;
  }
}

TEST(Doubt, IsNotThePapers) {
  vo::RgbdOdometry odometry(small_camera(), vo::preset_options(vo::TrackerPreset::paper));
  for (int i = 0; i < 4; ++i) {
    EXPECT_NE(odometry.track(plane_frame(small_camera(), sway(0), i)).status,
              TrackingStatus::uncertain);
  }
}

/// Returns what is made of the frame after one that repeats its image, where each frame becomes a
/// keyframe.
TrackingReason after_a_repeated_image(int references) {
  vo::TrackerOptions options = vo::preset_options(vo::TrackerPreset::best_measured);
  options.keyframes.every = 1;
  options.map.references = references;
  vo::RgbdOdometry odometry(small_camera(), options);
  for (int i = 0; i < 6; ++i) {
    odometry.track(plane_frame(small_camera(), sway(i), i));
  }
  EXPECT_EQ(odometry.track(plane_frame(small_camera(), sway(5), 6)).reason,
            TrackingReason::image_repeated);
  return odometry.track(plane_frame(small_camera(), sway(6), 7)).reason;
}

TEST(Doubt, GoesOnWhereNoKeyframeThatIsSureIsInView) {
  EXPECT_EQ(after_a_repeated_image(1), TrackingReason::map_uncertain);
  EXPECT_EQ(after_a_repeated_image(4), TrackingReason::none);
}

}  // namespace
