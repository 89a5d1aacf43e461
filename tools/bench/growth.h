#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/bench/frames.h"
#include "tools/bench/race.h"
#include "tools/bench/summary.h"
#include "tools/plot/linear_fit.h"
#include "vo/core/progress.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

/// Run time as a function of one quantity. A row's name is the value that produced it:
/// "points.max_points=2000", "pyramid.levels=3", "640x480".
struct GrowthTable {
  std::string quantity;  ///< points | levels | pixels
  std::string timed;     ///< "cpu" if processor time is fitted; empty without a fit
  std::vector<Summary> rows;
  std::vector<double> x;         ///< the quantity's value in each row
  std::vector<double> ms;        ///< median processor time in each row, ms
  std::optional<LinearFit> fit;  ///< line fitted to ms over x
};

/// Measures the tracker with growing numbers of edge points, with 1 to 5 pyramid levels, and on
/// frames from a quarter to twice the width and height, all in one interleaved run.
std::vector<GrowthTable> measure_growth(const Frames& input, const vo::TrackerOptions& base,
                                        const RaceOptions& options, const vo::Progress& progress);

}  // namespace tools
