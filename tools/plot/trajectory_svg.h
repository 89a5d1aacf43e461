#pragma once

#include <string>

#include "vo/geometry/trajectory.h"

namespace tools {

/// Truth (grey) and estimate (coloured by its distance from the truth at the same time) seen along
/// the axis of least extent, and below it the distance over time. The estimate is drawn as it is:
/// align it first if its origin is another. Without truth, the estimate alone.
std::string draw_trajectory(const vo::Trajectory& truth, const vo::Trajectory& estimate);

}  // namespace tools
