#include "vo/segmentation/free_space.h"

#include <gtest/gtest.h>

namespace {

constexpr float kEvidence = -3;

/// Two views from one place, a pixel to a tile, of a wall 2 m away.
struct TwoViews {
  vo::PyramidLevel own = wall();
  vo::PyramidLevel other = wall();

  static vo::PyramidLevel wall() {
    const vo::PinholeCamera camera =
        vo::PinholeCamera::from_horizontal_fov(vo::ViewTiles::kColumns, vo::ViewTiles::kRows, 60);
    const vo::CameraLevel level = vo::camera_levels(camera, {.levels = 1}).front();
    return {camera, level.rays, {}, {}, vo::DepthImage(camera.height, camera.width, 2.0F)};
  }

  vo::ViewTiles::Values evidence() const {
    vo::ViewTiles::Values sum{};
    vo::add_seen_through(own, other, vo::SE3(), kEvidence, sum);
    return sum;
  }
};

std::size_t tile_of(int u, int v) {
  return static_cast<std::size_t>(v * vo::ViewTiles::kColumns + u);
}

TEST(FreeSpace, SpeaksAgainstWhatIsNearerThanWhereTheOtherFrameSaw) {
  TwoViews views;
  views.own.depth(12, 10) = 1;
  views.own.depth(20, 30) = 1.9F;  // within the noise of depth
  vo::ViewTiles::Values expected{};
  expected[tile_of(10, 12)] = kEvidence;
  EXPECT_EQ(views.evidence(), expected);
}

TEST(FreeSpace, SaysNothingBesideHolesSurfacesAndTheBorder) {
  TwoViews views;
  views.own.depth(12, 10) = 1;
  views.other.depth(11, 9) = 0;  // it may have seen something there
  views.own.depth(12, 20) = 1;
  views.other.depth(13, 21) = 1;
  views.own.depth(0, 30) = 1;
  views.own.depth(20, 30) = 0;
  EXPECT_EQ(views.evidence(), vo::ViewTiles::Values{});
}

}  // namespace
