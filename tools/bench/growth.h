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

/// How the time grows with one quantity. A summary's name is the value that made it:
/// "edges.percentile=88", "pyramid.levels=3", "640x480".
struct GrowthTable {
  std::string quantity;  ///< points | levels | pixels
  std::string timed;     ///< cpu: whose median is fitted; empty without a fit
  std::vector<Summary> rows;
  std::vector<double> x;         ///< of each row: how many of the quantity
  std::vector<double> ms;        ///< of each row: the fitted time
  std::optional<LinearFit> fit;  ///< ms per one of the quantity, and the rest
};

/// The tracker with more and more edge points, with 1 to 5 pyramid levels, and on frames from a
/// quarter to twice the size in each direction, all in one race.
std::vector<GrowthTable> measure_growth(const Frames& input, const vo::TrackerOptions& base,
                                        const RaceOptions& options, const vo::Progress& progress);

}  // namespace tools
