#include "vo/segmentation/tile_mask.h"

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"

namespace {

using support::small_camera;
using vo::TileMask;
using vo::ViewTiles;

/// Frames without images, and a point in the middle of every tile on each level, 1 m away.
struct PointedTiles {
  vo::FramePyramid frame;
  vo::EdgePoints points;

  PointedTiles() {
    for (const vo::CameraLevel& level : vo::camera_levels(small_camera(), {.levels = 2})) {
      frame.levels.push_back({level.camera, {}, {}, {}, {}});
      vo::EdgePointLevel& middles = points.levels.emplace_back();
      middles.resize(ViewTiles::kCount);
      for (std::size_t k = 0; k < ViewTiles::kCount; ++k) {
        place(level.camera, k, middles);
      }
    }
  }

  static void place(const vo::PinholeCamera& camera, std::size_t k, vo::EdgePointLevel& middles) {
    const auto column = static_cast<int>(k) % ViewTiles::kColumns;
    const auto row = static_cast<int>(k) / ViewTiles::kColumns;
    middles.pixel[k] = {(2 * column + 1) * camera.width / (2 * ViewTiles::kColumns),
                        (2 * row + 1) * camera.height / (2 * ViewTiles::kRows)};
    const Eigen::Vector3d p = camera.unproject({middles.pixel[k].x, middles.pixel[k].y}, 1);
    middles.x_ref[k] = static_cast<float>(p.x());
    middles.y_ref[k] = static_cast<float>(p.y());
    middles.z_ref[k] = 1;
    middles.intensity[k] = static_cast<float>(k);
  }
};

TileMask first_and_fourteenth() {
  TileMask tiles;
  tiles.set(0);
  tiles.set(13);
  return tiles;
}

TEST(TileMask, LeavesOutPointsOnEveryLevel) {
  PointedTiles pointed;
  vo::leave_out(first_and_fourteenth(), pointed.frame, pointed.points);
  for (const vo::EdgePointLevel& level : pointed.points.levels) {
    ASSERT_EQ(level.size(), ViewTiles::kCount - 2);
    EXPECT_EQ(level.intensity.front(), 1);
    EXPECT_EQ(level.intensity[12], 14);
  }
}

TEST(TileMask, HoldsTilesWithTwoPoints) {
  PointedTiles pointed;
  EXPECT_TRUE(vo::tiles_with_points(pointed.frame, pointed.points).none());
  vo::EdgePointLevel& finest = pointed.points.levels.front();
  finest.pixel[2] = finest.pixel[0];
  finest.pixel[3] = finest.pixel[13];
  finest.pixel[4] = finest.pixel[13];
  EXPECT_EQ(vo::tiles_with_points(pointed.frame, pointed.points), first_and_fourteenth());
}

/// A camera one tile further to the right, at 1 m, sees each point a tile further to the left.
TEST(TileMask, LeavesOutWhatAnotherViewSeesThere) {
  PointedTiles pointed;
  const double tile_m = small_camera().width / (ViewTiles::kColumns * small_camera().fx);
  const vo::SE3 T_cur_ref(Eigen::Quaterniond::Identity(), Eigen::Vector3d(-tile_m, 0, 0));
  vo::leave_out({first_and_fourteenth(), pointed.frame, T_cur_ref}, pointed.points);
  const std::vector<float>& left = pointed.points.levels.front().intensity;
  ASSERT_EQ(left.size(), ViewTiles::kCount - 2);
  EXPECT_EQ(left[1], 2);
  EXPECT_EQ(left[13], 15);
}

TEST(TileMask, CountsTheShareOfPoints) {
  const PointedTiles pointed;
  EXPECT_DOUBLE_EQ(vo::share_in(first_and_fourteenth(), pointed.frame, pointed.points),
                   2.0 / ViewTiles::kCount);
}

TEST(TileMask, GrowsByTheNeighbours) {
  EXPECT_EQ(vo::grown(first_and_fourteenth()).count(), 4U + 6U);
  EXPECT_TRUE(vo::grown({}).none());
}

}  // namespace
