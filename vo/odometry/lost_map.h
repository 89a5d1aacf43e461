#pragma once

#include <cstddef>
#include <optional>

#include "vo/odometry/pose_history.h"
#include "vo/scale/scale_watch.h"
#include "vo/tracking/tracker.h"

namespace vo {

/// A map that the camera has left for a new one: its keyframes, in which the camera is looked for,
/// and the past maps that tell the new map's scale.
struct LostMap {
  Tracker tracker;
  ScaleWatch scale_watch;
  std::size_t first_pose = 0;  ///< index of the first pose that the new map has found

  /// Looks for a keyframe of the new map, whose pose there is `present.T_world_host`, in this one.
  /// Returns how the two maps are joined where the keyframe is found and the edges that both know
  /// tell the scale; the tracker and the watch then go on from it.
  std::optional<MapJoint> joint_with(PastMap present);
};

}  // namespace vo
