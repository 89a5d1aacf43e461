#include "synth/scene/placed.h"

namespace synth {

vo::SE3 T_world_camera_of(const Eigen::Affine3d& T_world_node) {
  const Eigen::Vector3d forward = light_direction_of(T_world_node);
  const Eigen::Vector3d down = -T_world_node.linear().col(1);
  const Eigen::Vector3d right = down.cross(forward).stableNormalized();
  if (!(right.squaredNorm() > 0)) {  // a flat node has no viewing direction
    return {Eigen::Quaterniond::Identity(), T_world_node.translation()};
  }
  Eigen::Matrix3d R_world_camera;
  R_world_camera << right, forward.cross(right), forward;
  return {Eigen::Quaterniond(R_world_camera), T_world_node.translation()};
}

Eigen::Vector3d light_direction_of(const Eigen::Affine3d& T_world_node) {
  return -T_world_node.linear().col(2).stableNormalized();
}

}  // namespace synth
