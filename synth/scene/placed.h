#pragma once

#include <Eigen/Geometry>

#include "vo/geometry/se3.h"

namespace synth {

/// Returns the pose T_world_camera (x right, y down, z forward) of a glTF camera, which looks along
/// its node's -z axis with +y up. A positive scale of the node does not change it.
vo::SE3 T_world_camera_of(const Eigen::Affine3d& T_world_node);

/// Returns the unit direction, world, in which a light shines, its node's -z axis; zero if the
/// node's z axis is zero.
Eigen::Vector3d light_direction_of(const Eigen::Affine3d& T_world_node);

}  // namespace synth
