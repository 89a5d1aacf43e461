#pragma once

#include <filesystem>
#include <string>

#include "vo/evaluation/evaluate.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// Returns the unit of the last digit with which a file in the TUM format gives positions, m: the
/// median over all numbers but zeros, because programs differ in how they write those. 0 where
/// there are none. Throws vo::Error where a line has no position.
double position_unit(const std::filesystem::path& trajectory);

/// Units of the last digits of positions, m in each trajectory's own scale.
struct PositionUnits {
  double truth = 0;
  double estimate = 0;
};

/// Returns why an estimate is too good to be true, in a sentence; empty where it is not. With
/// positions rounded to a unit the least absolute trajectory error (RMSE) that honest numbers can
/// be expected to have is half of it, sqrt(3) times the deviation unit / sqrt(12) of each
/// coordinate; and where the truth itself was copied, no position is further off than half a unit
/// in each coordinate. A camera that stands still is judged by neither.
std::string implausibility(const vo::Trajectory& truth, const vo::Trajectory& estimate,
                           vo::TrajectoryAlignment alignment, const PositionUnits& units);

}  // namespace tools
