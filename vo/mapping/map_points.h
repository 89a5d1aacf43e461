#pragma once

#include <vector>

#include "vo/image/edge_points.h"
#include "vo/mapping/hypotheses.h"

namespace vo {

/// Whether hypotheses of which nothing is known count.
enum class Guesses { left_out, included };

/// A pixel of one level that has hypotheses in or below it.
struct PointCell {
  cv::Point pixel;
  int parent =
      -1;  ///< index of the cell above it on the next coarser level, -1 where there is none
};

/// The cells of each level of an host, in scan order, whatever their depths. Those of the finest
/// are the hypotheses.
using PointCells = std::vector<std::vector<PointCell>>;

PointCells point_cells(const FramePyramid& host, const Hypotheses& hypotheses);

/// The hypotheses whose relative standard deviation is at most `max_sigma`, as the tracker takes
/// them: on coarser levels every pixel that has one below it, at the nearest of their depths.
EdgePoints map_points(const FramePyramid& host, const PointCells& cells,
                      const Hypotheses& hypotheses, const EdgePointOptions& options,
                      double max_sigma, Guesses guesses);

}  // namespace vo
