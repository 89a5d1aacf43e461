#pragma once

#include <string>

#include "vo/evaluation/evaluate.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// Returns an SVG with the truth during the estimate and the estimate, in the colours of its
/// distance from the truth at equal times, both projected along the axis of least extent, and below
/// them the distance over time. `alignment` is what moved the estimate onto the truth before, for
/// the title. Without truth the estimate is drawn alone; an empty estimate throws vo::Error.
std::string draw_trajectory(const vo::Trajectory& truth, const vo::Trajectory& estimate,
                            vo::TrajectoryAlignment alignment);

}  // namespace tools
