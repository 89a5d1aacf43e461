#pragma once

#include <array>
#include <bitset>
#include <cstddef>

#include <opencv2/core.hpp>

#include "vo/geometry/camera.h"

namespace vo {

/// The cells of a view, row by row, at any level of its pyramid.
template <int Columns, int Rows>
class ViewGrid {
 public:
  static constexpr int kColumns = Columns;
  static constexpr int kRows = Rows;
  static constexpr std::size_t kCount = std::size_t{Columns} * Rows;
  using Set = std::bitset<kCount>;
  using Values = std::array<float, kCount>;

  explicit ViewGrid(const PinholeCamera& camera)
      : columns_per_px_(static_cast<float>(kColumns) / static_cast<float>(camera.width)),
        rows_per_px_(static_cast<float>(kRows) / static_cast<float>(camera.height)) {}

  /// Returns the index of the cell of a pixel of the image.
  std::size_t of(float u, float v) const {
    const auto column = static_cast<std::size_t>((u + 0.5F) * columns_per_px_);
    const auto row = static_cast<std::size_t>((v + 0.5F) * rows_per_px_);
    return row * kColumns + column;
  }
  std::size_t of(cv::Point pixel) const {
    return of(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
  }

  /// Calls `visit` with the index of the cell and of each of its up to eight neighbours.
  template <typename Visit>
  static void for_each_around(std::size_t cell, Visit visit) {
    constexpr std::size_t kWidth = Columns;
    constexpr std::size_t kHeight = Rows;
    const std::size_t row = cell / kWidth;
    const std::size_t column = cell % kWidth;
    for (std::size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < kHeight; ++r) {
      for (std::size_t c = column > 0 ? column - 1 : 0; c <= column + 1 && c < kWidth; ++c) {
        visit(r * kWidth + c);
      }
    }
  }

 private:
  float columns_per_px_, rows_per_px_;
};

/// The cells whose correlation is judged as a whole. A cell holds some forty of 2000 points.
using ViewCells = ViewGrid<8, 6>;

/// The tiles of which each is static or moves by itself.
using ViewTiles = ViewGrid<40, 30>;

}  // namespace vo
