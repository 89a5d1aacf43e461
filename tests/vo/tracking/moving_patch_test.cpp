#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/tracking/tracker.h"

namespace {

using support::plane_frame;
using support::small_camera;
using support::sway;
using vo::ViewTiles;

constexpr int kPictureFrames = 30;

/// The place of a picture that hangs 1 m before the camera and goes to and fro, px. It covers
/// a quarter of the view.
cv::Rect picture_at(int frame) {
  const vo::PinholeCamera camera = small_camera();
  const int width = camera.width / 2;
  const double phase = 2 * std::numbers::pi * frame / 40;
  const int left = static_cast<int>((camera.width - width) * (0.5 + 0.5 * std::sin(phase)));
  return {left, camera.height / 4, width, camera.height / 2};
}

vo::RgbdFrame frame_with_picture(int index) {
  static const vo::SE3 elsewhere(Eigen::Quaterniond::Identity(), Eigen::Vector3d(2, 1, 0));
  static const vo::RgbdFrame shown = plane_frame(small_camera(), elsewhere, 0);
  vo::RgbdFrame frame = plane_frame(small_camera(), sway(index), index);
  const cv::Rect place = picture_at(index);
  frame.image = frame.image.clone();
  frame.depth = frame.depth.clone();
  shown.image(cv::Rect({0, 0}, place.size())).copyTo(frame.image(place));
  frame.depth(place).setTo(1.0F);
  return frame;
}

/// Counts tiles by whether they move in truth, and as found.
struct Found {
  double right = 0, missed = 0, wrong = 0;

  void add(const cv::Rect& place, const vo::TileMask& moving) {
    const int tile_px = small_camera().width / ViewTiles::kColumns;
    for (std::size_t tile = 0; tile < ViewTiles::kCount; ++tile) {
      const cv::Point corner(static_cast<int>(tile) % ViewTiles::kColumns * tile_px,
                             static_cast<int>(tile) / ViewTiles::kColumns * tile_px);
      const int both = (place & cv::Rect(corner, cv::Size(tile_px, tile_px))).area();
      const bool moves = 2 * both > tile_px * tile_px;
      right += moves && moving[tile] ? 1 : 0;
      missed += moves && !moving[tile] ? 1 : 0;
      wrong += !moves && moving[tile] ? 1 : 0;
    }
  }
};

TEST(MovingPatch, IsFoundAndDoesNotTakeTheCameraWithIt) {
  vo::RgbdOdometry odometry(small_camera());
  Found found;
  for (int i = 0; i < kPictureFrames; ++i) {
    const vo::TrackingResult result = odometry.track(frame_with_picture(i));
    ASSERT_NE(result.status, vo::TrackingStatus::lost) << i;
    const vo::SE3 T_error = (sway(0).inverse() * sway(i)).inverse() * result.T_world_camera;
    EXPECT_LT(T_error.translation().norm(), 8e-3) << i;
    if (i > 2) {
      found.add(picture_at(i), odometry.tracker().segmentation().moving());
    }
  }
  EXPECT_GT(found.right / (found.right + found.missed), 0.7);
  EXPECT_GT(found.right / (found.right + found.wrong), 0.7);
}

TEST(MovingPatch, IsNotFoundWhereNothingMoves) {
  vo::RgbdOdometry odometry(small_camera());
  for (int i = 0; i < kPictureFrames; ++i) {
    const vo::TrackingResult result = odometry.track(plane_frame(small_camera(), sway(i), i));
    EXPECT_LT(result.moving_fraction, 0.01) << i;
  }
}

/// Preset `paper` looks for nothing that moves.
TEST(MovingPatch, IsNotLookedForByThePaper) {
  vo::RgbdOdometry odometry(small_camera(), vo::preset_options(vo::TrackerPreset::paper));
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(odometry.track(frame_with_picture(i)).moving_fraction, 0);
  }
}

}  // namespace
