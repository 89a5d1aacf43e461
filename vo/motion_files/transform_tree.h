#pragma once

#include <map>
#include <string>
#include <vector>

#include "vo/geometry/trajectory.h"

namespace vo {

/// Transforms between named frames of coordinates over time, as ROS has them in /tf.
class TransformTree {
 public:
  /// Adds where a frame is in another at a time; the first parent of a frame stays its parent.
  void add(const std::string& parent, const std::string& child, const StampedPose& T_parent_child);

  /// Adds where a frame is in another for all time.
  void add_fixed(const std::string& parent, const std::string& child, const SE3& T_parent_child);

  /// Puts the poses of each frame in order, and takes as fixed those that never move.
  void finish();

  /// Returns the frames above a frame, the nearest first; empty if it is at the top or not known.
  std::vector<std::string> above(const std::string& frame) const;

  /// Returns the frames that move in their parents, in the order of their names.
  std::vector<std::string> moving() const;

  /// Returns the names of all frames, in their order.
  std::vector<std::string> frames() const;

  /// Returns T_parent_child over time, at the stamps of the moving transform nearest to `child`, as
  /// far as those above it, which are interpolated, have poses then. One pose at 0 s if nothing
  /// between the two moves. Throws Error unless `parent` is above `child`.
  Trajectory poses(const std::string& parent, const std::string& child) const;

 private:
  /// Where a frame is in its parent.
  struct Link {
    std::string parent;
    Trajectory T_parent_child;
    bool is_fixed = false;
  };

  std::map<std::string, Link> links_;  ///< by child
};

}  // namespace vo
