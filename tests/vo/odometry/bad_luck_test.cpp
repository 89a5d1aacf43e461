#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/support/plane_frames.h"
#include "tests/support/pose_near.h"
#include "vo/odometry/rgbd_odometry.h"

namespace {

using support::blank_frame;
using support::PoseNear;
using support::PoseTolerance;
using support::sway;
using support::sway_frame;
using vo::SE3;
using vo::TrackerPreset;
using vo::TrackingReason;
using vo::TrackingResult;
using vo::TrackingStatus;

/// A pixel is 10 mm wide on the plane and 0.27 deg: what every preset stays within on good images.
constexpr PoseTolerance kPixel{.translation_m = 10e-3, .rotation_deg = 0.27};

/// Defocus of 3 px, where the edges are a pixel wide: the paper's mask and its fixed scale misjudge
/// a blurred image by up to its blur and keep a part of it.
constexpr PoseTolerance kBlur{.translation_m = 30e-3, .rotation_deg = 0.8};

/// A turn of 10 deg between two frames.
SE3 sudden_turn() {
  vo::Vector6d turn = vo::Vector6d::Zero();
  turn.tail<3>() = Eigen::Vector3d(0.3, 1, -0.2).normalized() * 10 * std::numbers::pi / 180;
  return SE3::exp(turn);
}

/// What holds of every result, whatever the input.
void expect_sane(const TrackingResult& result) {
  EXPECT_TRUE(result.T_world_camera.translation().allFinite());
  EXPECT_TRUE(result.T_world_camera.rotation().coeffs().allFinite());
  EXPECT_TRUE(result.alignment.covariance.allFinite());
  EXPECT_TRUE(std::isfinite(result.readout.seconds));
  const bool has_reason =
      result.status == TrackingStatus::lost || result.status == TrackingStatus::uncertain;
  EXPECT_EQ(has_reason, result.reason != TrackingReason::none);
}

enum class Tracked { paper, best_measured, with_window };

vo::TrackerOptions options_of(Tracked tracked) {
  vo::TrackerOptions options = vo::preset_options(
      tracked == Tracked::paper ? TrackerPreset::paper : TrackerPreset::best_measured);
  if (tracked == Tracked::with_window) {
    options.window.adjust = vo::WindowAdjustment::depth;
    options.keyframes.every = 2;
  }
  return options;
}

class BadLuck : public testing::TestWithParam<Tracked> {
 protected:
  TrackingResult track(const vo::RgbdFrame& frame) {
    const TrackingResult result = odometry_.track(frame);
    expect_sane(result);
    return result;
  }

  TrackingResult track_sway(int index) { return track(sway_frame(camera_, index)); }

  /// Frames [first, end) of the sway, which must be tracked to within a pixel.
  void follow(int first, int end) {
    for (int i = first; i < end; ++i) {
      expect_followed(track_sway(i), i);
    }
  }

  static void expect_followed(const TrackingResult& result, int index) {
    EXPECT_NE(result.status, TrackingStatus::lost) << "frame " << index;
    EXPECT_THAT(result.T_world_camera, PoseNear(sway(index), kPixel)) << "frame " << index;
  }

  /// Follows the sway, then frames that show nothing, which must be lost, then the sway again.
  void expect_lost_then_found(const vo::RgbdFrame& nothing) {
    follow(0, 3);
    for (int i = 0; i < 2; ++i) {
      const TrackingResult lost = track(nothing);
      EXPECT_EQ(lost.status, TrackingStatus::lost);
      EXPECT_FALSE(lost.is_keyframe);
      EXPECT_THAT(lost.T_world_camera, PoseNear(sway(2), kPixel)) << "the last tracked pose";
    }
    follow(4, 7);
  }

  vo::PinholeCamera camera_ = vo::PinholeCamera::from_horizontal_fov(240, 180, 60);
  vo::RgbdOdometry odometry_{camera_, options_of(GetParam())};
};

std::string preset_name(const testing::TestParamInfo<Tracked>& info) {
  return info.param == Tracked::paper           ? "paper"
         : info.param == Tracked::best_measured ? "best_measured"
                                                : "with_window";
}

INSTANTIATE_TEST_SUITE_P(Preset, BadLuck,
                         testing::Values(Tracked::paper, Tracked::best_measured,
                                         Tracked::with_window),
                         preset_name);

TEST_P(BadLuck, WithoutAnyDepthNothingStarts) {
  for (int i = 0; i < 3; ++i) {
    vo::RgbdFrame frame = sway_frame(camera_, i);
    frame.depth.setTo(0);
    const TrackingResult result = track(frame);
    EXPECT_EQ(result.reason, TrackingReason::too_few_points);
    EXPECT_FALSE(result.is_keyframe);
  }
  EXPECT_TRUE(odometry_.trajectory().empty());
}

TEST_P(BadLuck, HalfOfTheDepthIsEnough) {
  for (int i = 0; i < 8; ++i) {
    vo::RgbdFrame frame = sway_frame(camera_, i);
    for (int pixel = 0; pixel < frame.depth.rows * frame.depth.cols; ++pixel) {
      if (vo::mixed_uniform(static_cast<std::uint64_t>(pixel + 1000000 * i)) < 0.5) {
        frame.depth(pixel / frame.depth.cols, pixel % frame.depth.cols) = 0;
      }
    }
    expect_followed(track(frame), i);
  }
}

/// A sensor's invalid depth in any spelling.
TEST_P(BadLuck, DepthThatIsNoNumberIsNoDepth) {
  const float bad[] = {std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::infinity(),
                       -std::numeric_limits<float>::infinity(),
                       -1.5F,
                       1e-30F,
                       1e30F};
  for (int i = 0; i < 8; ++i) {
    vo::RgbdFrame frame = sway_frame(camera_, i);
    for (int pixel = i; pixel < frame.depth.rows * frame.depth.cols; pixel += 5) {
      frame.depth(pixel / frame.depth.cols, pixel % frame.depth.cols) = bad[pixel / 5 % 6];
    }
    expect_followed(track(frame), i);
  }
}

TEST_P(BadLuck, ABlackFrameIsLost) {
  expect_lost_then_found(blank_frame(camera_, 0, 3));
}

TEST_P(BadLuck, AWhiteFrameIsLost) {
  expect_lost_then_found(blank_frame(camera_, 255, 3));
}

TEST_P(BadLuck, AWallWithoutTextureIsLost) {
  expect_lost_then_found(blank_frame(camera_, 120, 3));
}

TEST_P(BadLuck, NothingStartsOnAWallWithoutTexture) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(track(blank_frame(camera_, 120, i)).reason, TrackingReason::too_few_points);
  }
}

TEST_P(BadLuck, ABlurredFrameIsFollowedOrLost) {
  follow(0, 3);
  vo::RgbdFrame blurred = sway_frame(camera_, 3);
  cv::GaussianBlur(blurred.image, blurred.image, {}, 3);
  const TrackingResult result = track(blurred);
  if (result.status == TrackingStatus::tracked) {
    EXPECT_THAT(result.T_world_camera, PoseNear(sway(3), kBlur));
  }
  for (int i = 4; i < 7; ++i) {
    EXPECT_THAT(track_sway(i).T_world_camera,
                PoseNear(sway(i), GetParam() == Tracked::paper ? kBlur : kPixel));
  }
}

TEST_P(BadLuck, FrozenFramesStandStill) {
  follow(0, 3);
  vo::RgbdFrame frozen = sway_frame(camera_, 2);
  for (int i = 3; i < 8; ++i) {
    frozen.timestamp = i / 30.0;
    expect_followed(track(frozen), 2);
  }
  follow(3, 6);
}

TEST_P(BadLuck, RepeatedFramesStandStill) {
  follow(0, 3);
  for (int i = 0; i < 5; ++i) {
    expect_followed(track_sway(2), 2);
  }
  follow(3, 6);
}

/// Images that moved while the clock stood still, or as good as: no motion is infinitely fast.
TEST_P(BadLuck, AStoppedClockIsFollowed) {
  for (const double step : {0.0, 1e-9, 1e-5}) {
    vo::RgbdOdometry odometry(camera_, options_of(GetParam()));
    for (int i = 0; i < 10; ++i) {
      vo::RgbdFrame frame = sway_frame(camera_, i);
      frame.timestamp = 1 + step * i;
      const TrackingResult result = odometry.track(frame);
      expect_sane(result);
      expect_followed(result, i);
      EXPECT_TRUE(GetParam() == Tracked::paper ||
                  (result.T_world_camera.translation() - sway(i).translation()).norm() < 2e-3)
          << "a fifth of a pixel, frame " << i;
    }
  }
}

TEST_P(BadLuck, DroppedFramesAreBridged) {
  follow(0, 4);
  follow(6, 9);
}

TEST_P(BadLuck, SwappedFramesAreFollowed) {
  for (const int i : {0, 1, 2, 4, 3, 5, 6}) {
    expect_followed(track_sway(i), i);
  }
}

/// The paper does not search: it is lost, and not wrong.
TEST_P(BadLuck, ASuddenTurnIsFollowedOrLost) {
  follow(0, 3);
  const SE3 T_world_turned = sway(2) * sudden_turn();
  const TrackingResult result = track(support::plane_frame(camera_, T_world_turned, 3));
  EXPECT_EQ(result.status,
            GetParam() == Tracked::paper ? TrackingStatus::lost : TrackingStatus::tracked);
  if (result.status == TrackingStatus::tracked) {
    EXPECT_THAT(result.T_world_camera, PoseNear(T_world_turned, kPixel));
  }
}

/// Ten frames of darkness during which the camera moves by 6 cm and 7 deg.
TEST_P(BadLuck, ACoveredCameraIsFoundAgain) {
  follow(0, 4);
  for (int i = 4; i < 14; ++i) {
    EXPECT_EQ(track(blank_frame(camera_, 0, i)).status, TrackingStatus::lost);
  }
  if (GetParam() != Tracked::paper) {
    follow(14, 18);
    return;
  }
  const TrackingResult result = track_sway(14);
  if (result.status == TrackingStatus::tracked) {
    expect_followed(result, 14);
  }
}

/// The paper does not compare depths. The others follow a camera though a part of what it measures
/// is something else, but do not believe in a place where it was not expected.
TEST_P(BadLuck, DepthsThatDisagreeAreDoubted) {
  const auto farther = [&](int index, double share) {
    const vo::RgbdFrame frame = sway_frame(camera_, index);
    vo::RgbdFrame changed{frame.timestamp, frame.image, frame.depth.clone()};
    changed.depth.colRange(0, static_cast<int>(share * camera_.width)) *= 1.2;
    return changed;
  };
  const TrackingReason doubt =
      GetParam() == Tracked::paper ? TrackingReason::none : TrackingReason::depths_disagree;
  follow(0, 3);
  EXPECT_EQ(track(farther(3, 1)).reason, doubt);
  EXPECT_EQ(track(farther(4, 0.3)).reason, doubt);
  if (GetParam() != Tracked::paper) {
    follow(5, 7);
    expect_followed(track(farther(7, 0.3)), 7);
  }
}

/// The paper compares intensities as they are: a jump is an error it cannot see, but only one.
TEST_P(BadLuck, AJumpOfTheExposureIsFollowed) {
  for (const double gain : {0.5, 2.0}) {
    vo::RgbdOdometry odometry(camera_, options_of(GetParam()));
    for (int i = 0; i < 8; ++i) {
      vo::RgbdFrame frame = sway_frame(camera_, i);
      frame.image.convertTo(frame.image, -1, i < 4 ? 1 : gain);
      const TrackingResult result = odometry.track(frame);
      expect_sane(result);
      if (GetParam() != Tracked::paper) {
        expect_followed(result, i);
      }
    }
  }
}

/// Halves of odd sizes, and images that are too small for a second level or for edges at all.
TEST_P(BadLuck, AnyImageSizeIsFollowedOrLost) {
  for (const auto& [width, height] : {std::pair{161, 121}, {40, 30}, {24, 20}}) {
    const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(width, height, 60);
    const double pixel_m = 2 / camera.fx;
    vo::RgbdOdometry odometry(camera, options_of(GetParam()));
    for (int i = 0; i < 8; ++i) {
      const TrackingResult result = odometry.track(sway_frame(camera, i));
      expect_sane(result);
      if (result.status == TrackingStatus::tracked) {
        EXPECT_THAT(result.T_world_camera, PoseNear(sway(i), PoseTolerance{pixel_m, 50 * pixel_m}))
            << width << "x" << height << " frame " << i;
      }
      EXPECT_TRUE(width < 160 || result.status != TrackingStatus::lost);
    }
  }
}

struct Stand {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  ///< m, of the positions; the truth is 0
  double spread_m = 0;                             ///< standard deviation about the mean
  double predicted_m = 0;                          ///< by the last frame's covariance
  double worst_m = 0;                              ///< of any frame
};

/// A camera that stands still for some frames, with noise of a standard deviation in grey levels.
Stand stand(double noise, int frames) {
  const vo::PinholeCamera camera = support::small_camera();
  const vo::RgbdFrame clean = support::plane_frame(camera, SE3(), 0);
  vo::RgbdOdometry odometry(camera, vo::preset_options(TrackerPreset::best_measured));
  Stand found;
  double squares = 0;
  for (int i = 0; i < frames; ++i) {
    vo::RgbdFrame frame =
        noise > 0 ? support::with_noise(clean, noise, static_cast<std::uint64_t>(i)) : clean;
    frame.timestamp = i / 30.0;
    const TrackingResult result = odometry.track(frame);
    expect_sane(result);
    EXPECT_NE(result.status, TrackingStatus::lost) << "frame " << i;
    const Eigen::Vector3d position = result.T_world_camera.translation();
    found.worst_m = std::max(found.worst_m, position.norm());
    found.mean += position / frames;
    squares += position.squaredNorm() / frames;
    found.predicted_m = std::sqrt(result.alignment.covariance.topLeftCorner<3, 3>().trace());
  }
  found.spread_m = std::sqrt(squares - found.mean.squaredNorm());
  return found;
}

TEST(StationaryCamera, DoesNotDrift) {
  EXPECT_LT(stand(0, 300).worst_m, 5e-5);
}

/// The covariance holds what independent noise does and more: what all frames have in common with
/// the first. None is farther than 4 standard deviations, and 300 frames do not add up.
TEST(StationaryCamera, ShakesByItsCovarianceInNoise) {
  const Stand found = stand(2, 300);
  EXPECT_LT(found.spread_m, found.predicted_m);
  EXPECT_GT(found.spread_m, 0.1 * found.predicted_m);
  EXPECT_LT(found.mean.norm(), 4 * found.predicted_m);
  EXPECT_LT(found.worst_m, found.mean.norm() + 4 * found.predicted_m);
  EXPECT_LT(found.worst_m, 5e-4) << "half a millimetre, a twelfth of a pixel";
}

/// Bits, not tolerances: noise, a loss and a search included.
TEST_P(BadLuck, TwoRunsGiveTheSameBits) {
  vo::RgbdOdometry again(camera_, options_of(GetParam()));
  for (int i = 0; i < 8; ++i) {
    const vo::RgbdFrame frame =
        i == 4 ? blank_frame(camera_, 0, i) : support::with_noise(sway_frame(camera_, i), 3, 7);
    const TrackingResult first = track(frame);
    const TrackingResult second = again.track(frame);
    EXPECT_EQ(first.status, second.status);
    EXPECT_EQ(first.T_world_camera.translation(), second.T_world_camera.translation());
    EXPECT_EQ(first.T_world_camera.rotation().coeffs(), second.T_world_camera.rotation().coeffs());
    EXPECT_EQ(first.alignment.covariance, second.alignment.covariance);
    EXPECT_EQ(first.readout.seconds, second.readout.seconds);
  }
}

}  // namespace
