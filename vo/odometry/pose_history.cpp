#include "vo/odometry/pose_history.h"

#include <algorithm>

namespace vo {

SE3 MapJoint::operator()(const SE3& T_from_other) const {
  const SE3 T_camera_other = T_from_camera.inverse() * T_from_other;
  return T_to_camera * SE3(T_camera_other.rotation(), scale * T_camera_other.translation());
}

void PoseHistory::add(double timestamp, const SE3& T_world_camera, MonoState state) {
  trajectory_.push_back({timestamp, T_world_camera});
  states_.push_back(state);
}

void PoseHistory::forget_since(double timestamp) {
  while (!trajectory_.empty() && trajectory_.back().timestamp >= timestamp) {
    trajectory_.pop_back();
    states_.pop_back();
  }
}

void PoseHistory::join_since(std::size_t first, const MapJoint& joint, bool scale_is_trusted) {
  for (std::size_t i = first; i < trajectory_.size(); ++i) {
    trajectory_[i].T_world_camera = joint(trajectory_[i].T_world_camera);
    if (scale_is_trusted && states_[i] == MonoState::scale_uncertain) {
      states_[i] = MonoState::tracking;
    }
  }
}

std::size_t PoseHistory::count(MonoState state) const {
  return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), state));
}

bool PoseHistory::has_pose_in_map() const {
  return std::any_of(states_.begin(), states_.end(), is_in_map);
}

}  // namespace vo
