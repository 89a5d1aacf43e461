#pragma once

#include <cstddef>
#include <vector>

#include "vo/geometry/trajectory.h"
#include "vo/odometry/mono_state.h"

namespace vo {

/// A similarity from the world of one map to that of another: a camera pose of both worlds, and the
/// length of the other world's metre in units of the first.
struct MapJoint {
  SE3 T_from_camera;  ///< pose in the map that is moved
  SE3 T_to_camera;    ///< pose of the same camera in the map that it is joined to
  double scale = 1;   ///< lengths in the second map over lengths in the first

  /// Returns a pose of the first map's world in that of the second.
  SE3 operator()(const SE3& T_from_other) const;
};

/// The poses of all frames that have one, each with the state in which it was found.
class PoseHistory {
 public:
  void add(double timestamp, const SE3& T_world_camera, MonoState state);

  /// Forgets the poses of frames from this timestamp on.
  void forget_since(double timestamp);

  /// Moves the poses from this index on to the map that theirs is joined to. Where the scale is
  /// trusted, none of them is of uncertain scale any longer.
  void join_since(std::size_t first, const MapJoint& joint, bool scale_is_trusted);

  const Trajectory& trajectory() const { return trajectory_; }
  std::size_t size() const { return trajectory_.size(); }
  std::size_t count(MonoState state) const;
  bool has_pose_in_map() const;

 private:
  Trajectory trajectory_;
  std::vector<MonoState> states_;  ///< one per pose
};

}  // namespace vo
