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

/// The pose at a time between two poses of the trajectory, on the geodesic of SE(3) between them:
/// T_a exp(s log(T_a^-1 T_b)). Nothing outside the trajectory's time span.
std::optional<SE3> pose_at(const Trajectory& trajectory, double timestamp);

/// Sum of the distances between consecutive camera centres, m.
double path_length(const Trajectory& trajectory);

}  // namespace vo
