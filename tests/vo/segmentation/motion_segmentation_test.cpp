#include "vo/segmentation/motion_segmentation.h"

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/segmentation/tile_surfaces.h"

namespace {

using support::small_camera;
using vo::TileEvidence;
using vo::ViewTiles;

constexpr int kWidth = 10;  // tiles, of what moves

/// Returns the tiles' depths of a wall 4 m away, before which something hangs at 1 m, from this
/// column of tiles on.
ViewTiles::Values thing_at(int column) {
  const vo::PinholeCamera camera = small_camera();
  vo::RgbdFrame frame{0, vo::ByteImage(camera.height, camera.width, uchar{100}),
                      vo::DepthImage(camera.height, camera.width, 4.0F)};
  const int tile_px = camera.width / ViewTiles::kColumns;
  frame.depth.colRange(column * tile_px, (column + kWidth) * tile_px).setTo(1.0F);
  return vo::tile_depths(vo::build_pyramid(frame, camera, {.levels = 4}));
}

bool is_on_thing(std::size_t tile, int column) {
  const int c = static_cast<int>(tile) % ViewTiles::kColumns;
  return c >= column && c < column + kWidth;
}

TileEvidence evidence_of(int column) {
  TileEvidence evidence;
  for (std::size_t tile = 0; tile < evidence.size(); ++tile) {
    evidence[tile] = is_on_thing(tile, column) ? -3.0F : 1.0F;
  }
  return evidence;
}

/// The thing goes a tile to the right each frame; after the first nothing is seen of its motion.
TEST(MotionSegmentation, KeepsTheLabelOnWhatMoves) {
  vo::MotionSegmentation segmentation;
  ViewTiles::Values depths = thing_at(5);
  segmentation.update(depths, vo::log_odds_after(segmentation.expected(depths), evidence_of(5)));
  segmentation.update(depths, vo::log_odds_after(segmentation.expected(depths), evidence_of(5)));
  for (int column = 6; column < 9; ++column) {
    depths = thing_at(column);
    segmentation.update(depths, segmentation.expected(depths));
    for (std::size_t tile = 0; tile < ViewTiles::kCount; ++tile) {
      EXPECT_EQ(segmentation.moving()[tile], is_on_thing(tile, column)) << column << ", " << tile;
    }
    EXPECT_NEAR(segmentation.moving_fraction(), 1.0 * kWidth / ViewTiles::kColumns, 1e-9);
  }
}

TEST(MotionSegmentation, ForgetsWhatItNoLongerSees) {
  vo::MotionSegmentation segmentation;
  const ViewTiles::Values depths = thing_at(5);
  segmentation.update(depths, vo::log_odds_after(segmentation.expected(depths), evidence_of(5)));
  EXPECT_TRUE(segmentation.moving().any());
  for (int i = 0; i < 10; ++i) {
    segmentation.update(depths, segmentation.expected(depths));
  }
  EXPECT_TRUE(segmentation.moving().none());
  segmentation.reset();
  EXPECT_EQ(segmentation.expected(depths), TileEvidence{});
}

TEST(MotionSegmentation, BelievesNoSingleFrameForEver) {
  TileEvidence expected;
  expected.fill(1);
  TileEvidence evidence;
  evidence.fill(-100);
  EXPECT_TRUE(vo::moving_tiles(vo::log_odds_after(expected, evidence)).none());
  EXPECT_TRUE(vo::moving_tiles(vo::log_odds_after({}, evidence)).all());
}

/// With another motion than before tile 0 still agrees, tile 1, which agreed before, disagrees a
/// little, and tile 2 disagreed before as it does now.
TEST(MotionSegmentation, LetsWhatAgreedWithTheOtherMotionMoveAlongWithThat) {
  TileEvidence expected;
  expected.fill(0.8F);
  TileEvidence before{};
  TileEvidence now{};
  before[0] = 2;
  before[1] = 2;
  before[2] = -0.5F;
  now[0] = 0.75F;
  now[1] = -0.25F;
  now[2] = -0.25F;
  expected[3] = -3;
  const TileEvidence after = vo::log_odds_after_change(expected, before, now);
  EXPECT_EQ(after[0], 0.75F);
  EXPECT_EQ(after[1], -2.25F);
  EXPECT_EQ(after[2], -0.25F);
  EXPECT_EQ(after[3], -3) << "what moved before moves on";
}

}  // namespace
