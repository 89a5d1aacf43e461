#pragma once

#include <vector>

#include "vo/image/edge_points.h"
#include "vo/mapping/hypotheses.h"

namespace vo {

/// States whether hypotheses whose depth is only a guess become points.
enum class Guesses { left_out, included };

/// A pixel of one level that has hypotheses in or below it.
struct PointCell {
  cv::Point pixel;
  int parent =
      -1;  ///< index of the cell above it on the next coarser level, -1 where there is none
};

/// The cells of each level of a host, in scan order, whatever their depths; on the finest level
/// they are the hypotheses.
using PointCells = std::vector<std::vector<PointCell>>;

PointCells point_cells(const FramePyramid& host, const Hypotheses& hypotheses);

/// Returns the points whose relative standard deviation is at most `max_sigma`. On coarser levels
/// every pixel with such points below it is a point: at their mean depth, or the nearest if they
/// differ.
EdgePoints map_points(const FramePyramid& host, const PointCells& cells,
                      const Hypotheses& hypotheses, const EdgePointOptions& options,
                      double max_sigma, Guesses guesses);

}  // namespace vo
