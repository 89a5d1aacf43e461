#include "vo/segmentation/tile_surfaces.h"

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"

namespace {

using support::small_camera;
using vo::ViewTiles;

/// A grey wall 4 m away, in front of whose left quarter something hangs at 1 m.
vo::FramePyramid wall_and_curtain(int grey) {
  const vo::PinholeCamera camera = small_camera();
  vo::RgbdFrame frame{0, vo::ByteImage(camera.height, camera.width, static_cast<uchar>(grey)),
                      vo::DepthImage(camera.height, camera.width, 4.0F)};
  frame.depth.colRange(0, camera.width / 4).setTo(1.0F);
  return vo::build_pyramid(frame, camera, {.levels = 4});
}

vo::TileMask covered(const vo::FramePyramid& frame) {
  return vo::covered_tiles(frame, vo::tile_depths(frame));
}

TEST(TileSurfaces, TellsFarTilesFromNearOnes) {
  const vo::TileMask far = vo::far_tiles(vo::tile_depths(wall_and_curtain(100)));
  for (std::size_t tile = 0; tile < ViewTiles::kCount; ++tile) {
    EXPECT_EQ(far[tile], tile % ViewTiles::kColumns >= ViewTiles::kColumns / 4) << tile;
  }
}

TEST(TileSurfaces, CountTilesBySquaredDepth) {
  vo::ViewTiles::Values log_odds;
  log_odds.fill(1);
  for (std::size_t tile = 0; tile < ViewTiles::kCount; ++tile) {
    if (tile % ViewTiles::kColumns < ViewTiles::kColumns / 4) {
      log_odds[tile] = -3;
    }
  }
  const ViewTiles::Values depths = vo::tile_depths(wall_and_curtain(100));
  const vo::SurfaceAreas all = vo::surface_areas(log_odds, depths, ~vo::TileMask());
  EXPECT_NEAR(all.moving_ratio(), 1.0 / (3 * 16), 1e-6);

  vo::TileMask upper_half;
  for (std::size_t tile = 0; tile < ViewTiles::kCount / 2; ++tile) {
    upper_half.set(tile);
  }
  const vo::SurfaceAreas half = vo::surface_areas(log_odds, depths, upper_half);
  EXPECT_NEAR(half.of_static, all.of_static / 2, 1e-6);
  EXPECT_NEAR(half.of_moving, all.of_moving / 2, 1e-6);
}

TEST(TileSurfaces, AreCoveredWhereTheImageIsBlackAndDepthIsMeasured) {
  EXPECT_TRUE(covered(wall_and_curtain(0)).all());
  EXPECT_TRUE(covered(wall_and_curtain(4)).none());
  vo::FramePyramid dark = wall_and_curtain(0);
  dark.levels.back().depth.setTo(0);
  EXPECT_TRUE(covered(dark).none()) << "a lens cap covers both sensors";
}

}  // namespace
