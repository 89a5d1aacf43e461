#pragma once

#include <vector>

#include "vo/bootstrap/start_adjustment.h"
#include "vo/geometry/se3.h"

namespace vo {

/// Returns the velocity of each frame of a start, the first included: the twist of T_world_camera
/// in the camera's own frame, [1/s in units of the poses; rad/s], from the frames before and after.
/// `timestamps` are those of all frames, s.
std::vector<Vector6d> start_velocities(const StartViews& start,
                                       const std::vector<double>& timestamps);

/// Sets the bends of all pairs: what a second of read-out time moves the second ray by, to first
/// order, when the cameras move with these velocities.
void bend_pairs(const std::vector<Vector6d>& velocities, StartViews& start);

}  // namespace vo
