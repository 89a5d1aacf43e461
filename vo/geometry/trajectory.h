#pragma once

#include <optional>
#include <vector>

#include "vo/geometry/se3.h"

namespace vo {

struct StampedPose {
  double timestamp = 0;  ///< s
  SE3 T_world_camera;
};

/// Poses in strictly increasing time.
using Trajectory = std::vector<StampedPose>;

/// Returns the pose at a time, interpolated on the geodesic of SE(3) between the poses before and
/// after it: T_a exp(s log(T_a^-1 T_b)). Empty outside the trajectory's time span.
std::optional<SE3> pose_at(const Trajectory& trajectory, double timestamp);

/// Returns the sum of the distances between consecutive camera centres, m.
double path_length(const Trajectory& trajectory);

}  // namespace vo
