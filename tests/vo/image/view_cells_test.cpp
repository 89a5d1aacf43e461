#include "vo/image/view_cells.h"

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"

namespace {

using support::small_camera;

TEST(ViewCells, CoverTheImage) {
  const vo::ViewCells cells(small_camera());
  EXPECT_EQ(cells.of(-0.5F, -0.5F), 0U);
  EXPECT_EQ(cells.of(static_cast<float>(small_camera().width) - 0.6F,
                     static_cast<float>(small_camera().height) - 0.6F),
            vo::ViewCells::kCount - 1);
}

/// A point in the middle of every cell on each level: those of the cells named go, all others stay.
TEST(ViewCells, AreLeftOutOnEveryLevel) {
  vo::FramePyramid frame;
  vo::EdgePoints points;
  for (const vo::CameraLevel& level : vo::camera_levels(small_camera(), {.levels = 2})) {
    frame.levels.push_back({level.camera, {}, {}, {}, {}});
    vo::EdgePointLevel& middles = points.levels.emplace_back();
    middles.resize(vo::ViewCells::kCount);
    for (std::size_t k = 0; k < vo::ViewCells::kCount; ++k) {
      const auto column = static_cast<int>(k) % vo::ViewCells::kColumns;
      const auto row = static_cast<int>(k) / vo::ViewCells::kColumns;
      middles.pixel[k] = {(2 * column + 1) * level.camera.width / (2 * vo::ViewCells::kColumns),
                          (2 * row + 1) * level.camera.height / (2 * vo::ViewCells::kRows)};
      middles.z_ref[k] = static_cast<float>(k);
    }
  }
  vo::ViewCells::Set cells;
  cells.set(0);
  cells.set(13);
  vo::leave_out(cells, frame, points);
  for (const vo::EdgePointLevel& level : points.levels) {
    ASSERT_EQ(level.size(), vo::ViewCells::kCount - 2);
    EXPECT_EQ(level.z_ref.front(), 1);
    EXPECT_EQ(level.z_ref[12], 14);
  }
}

}  // namespace
