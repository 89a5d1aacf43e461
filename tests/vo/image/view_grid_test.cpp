#include "vo/image/view_grid.h"

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"

namespace {

using support::small_camera;
using vo::ViewTiles;

TEST(ViewGrid, CoversTheImage) {
  const vo::ViewCells cells(small_camera());
  EXPECT_EQ(cells.of(-0.5F, -0.5F), 0U);
  EXPECT_EQ(cells.of(static_cast<float>(small_camera().width) - 0.6F,
                     static_cast<float>(small_camera().height) - 0.6F),
            vo::ViewCells::kCount - 1);
}

std::size_t count_around(std::size_t tile) {
  std::size_t count = 0;
  ViewTiles::for_each_around(tile, [&](std::size_t) { ++count; });
  return count;
}

TEST(ViewGrid, HasFourToNineTilesAroundATile) {
  EXPECT_EQ(count_around(0), 4U) << "a corner";
  EXPECT_EQ(count_around(1), 6U) << "a border";
  EXPECT_EQ(count_around(ViewTiles::kColumns + 1), 9U);
  EXPECT_EQ(count_around(ViewTiles::kCount - 1), 4U);
}

}  // namespace
