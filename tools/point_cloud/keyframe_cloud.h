#pragma once

#include <deque>
#include <map>
#include <memory>

#include "tools/point_cloud/point_cloud.h"
#include "vo/sequence_odometry/track_mono.h"
#include "vo/sequence_odometry/track_sequence.h"
#include "vo/tracking/local_map.h"

namespace tools {

/// Collects the finest edge points of all keyframes of a run. A keyframe's pose and depths may be
/// adjusted until the tracker forgets it, so that its points are taken only then. Points are those
/// of the instant of the pose; what a rolling shutter moves is not taken out.
class KeyframeCloud {
 public:
  /// Returns a callback that collects the points after each frame and then calls another one, if
  /// there is one. It refers to this object.
  vo::FrameObserver observer(vo::FrameObserver other);

  /// Returns a callback that collects the points of keyframes whose poses are known in a map. Those
  /// of a map that is joined to an earlier one are left out up to then: their world and scale are
  /// not the earlier one's. It refers to this object.
  vo::MonoObserver mono_observer();

  /// Returns the points of all keyframes, oldest first, those that the tracker still holds too.
  EdgeCloud finish();

 private:
  void observe(const vo::LocalMap& map);
  void leave_out_last_map();
  void take(const vo::Keyframe& keyframe);

  std::deque<std::shared_ptr<const vo::Keyframe>> held_;  ///< keyframes after the last frame
  std::map<double, EdgeCloud> taken_;  ///< points of forgotten keyframes, by their timestamp, s
  double first_of_map_ = 0;  ///< s, timestamp that is earlier than the last map's keyframes
};

/// Returns the points of a keyframe's finest level in the world.
EdgeCloud points_of(const vo::Keyframe& keyframe);

}  // namespace tools
