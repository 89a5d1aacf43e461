#pragma once

#include <string>

#include "vo/geometry/trajectory.h"

namespace tools {

/// Returns an SVG with the truth (grey) and the estimate (coloured by its distance from the truth
/// at equal times) projected along the axis of least extent, and below it the distance over time.
/// The estimate is not aligned. Without truth it is drawn alone; an empty estimate throws
/// vo::Error.
std::string draw_trajectory(const vo::Trajectory& truth, const vo::Trajectory& estimate);

}  // namespace tools
