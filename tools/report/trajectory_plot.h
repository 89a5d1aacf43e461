#pragma once

#include <string>

#include "vo/evaluation/evaluate.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// Returns an SVG with the truth during the estimate and the estimate after alignment, as it is
/// judged, in the colours of its distance from the truth at equal times, both projected along the
/// axis of least extent, and below them the distance over time. The title names alignment, plane
/// and frame. An estimate of which fewer than three poses match is drawn as it is; without truth it
/// is drawn alone, in its own world. An empty estimate throws vo::Error.
std::string draw_trajectory(const vo::Trajectory& truth, const vo::Trajectory& estimate,
                            vo::TrajectoryAlignment alignment);

}  // namespace tools
