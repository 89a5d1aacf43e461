#include "vo/geometry/trajectory.h"

#include <algorithm>

namespace vo {

std::optional<SE3> pose_at(const Trajectory& trajectory, double timestamp) {
  if (trajectory.empty() || timestamp < trajectory.front().timestamp ||
      timestamp > trajectory.back().timestamp) {
    return std::nullopt;
  }
  const auto after =
      std::lower_bound(trajectory.begin(), trajectory.end(), timestamp,
                       [](const StampedPose& pose, double time) { return pose.timestamp < time; });
  if (after->timestamp == timestamp) {
    return after->T_world_camera;
  }
  const StampedPose& a = *(after - 1);
  const double fraction = (timestamp - a.timestamp) / (after->timestamp - a.timestamp);
  const SE3 T_a_b = a.T_world_camera.inverse() * after->T_world_camera;
  return a.T_world_camera * SE3::exp(fraction * T_a_b.log());
}

double path_length(const Trajectory& trajectory) {
  double length = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length += (trajectory[i].T_world_camera.translation() -
               trajectory[i - 1].T_world_camera.translation())
                  .norm();
  }
  return length;
}

}  // namespace vo
