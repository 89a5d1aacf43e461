#pragma once

#include <bitset>
#include <cstddef>

#include "vo/geometry/camera.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"

namespace vo {

/// The cells of the view, 8 by 6, row by row. A cell holds some forty of 2000 points.
class ViewCells {
 public:
  static constexpr int kColumns = 8;
  static constexpr int kRows = 6;
  static constexpr std::size_t kCount = kColumns * kRows;
  using Set = std::bitset<kCount>;

  explicit ViewCells(const PinholeCamera& camera)
      : columns_per_px_(static_cast<float>(kColumns) / static_cast<float>(camera.width)),
        rows_per_px_(static_cast<float>(kRows) / static_cast<float>(camera.height)) {}

  /// Returns the index of the cell of a pixel of the image.
  std::size_t of(float u, float v) const {
    const auto column = static_cast<std::size_t>((u + 0.5F) * columns_per_px_);
    const auto row = static_cast<std::size_t>((v + 0.5F) * rows_per_px_);
    return row * kColumns + column;
  }

 private:
  float columns_per_px_, rows_per_px_;
};

/// Removes the points that lie in these cells of their own frame's view.
void leave_out(const ViewCells::Set& cells, const FramePyramid& frame, EdgePoints& points);

}  // namespace vo
