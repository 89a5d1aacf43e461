#include "vo/odometry/lost_map.h"

#include <cmath>
#include <utility>

namespace vo {

std::optional<MapJoint> LostMap::joint_with(PastMap present) {
  const TrackingResult found = tracker.track(present.host);
  if (found.status == TrackingStatus::lost) {
    return std::nullopt;
  }
  const SE3 T_new_camera = std::exchange(present.T_world_host, found.T_world_camera);
  const std::optional<double> log_scale = scale_watch.take_up(present);
  if (!log_scale) {
    return std::nullopt;
  }
  return MapJoint{T_new_camera, found.T_world_camera, std::exp(-*log_scale)};
}

}  // namespace vo
