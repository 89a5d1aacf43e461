#pragma once

#include <Eigen/Geometry>

#include "vo/geometry/se3.h"

namespace synth {

/// T_world_camera, x right, y down, z forward, of a glTF camera on a node: it looks along -z and
/// has y up, and scale does not change it.
vo::SE3 T_world_camera_of(const Eigen::Affine3d& T_world_node);

/// Where a light on a node shines to: -z, unit; zero where the node's z is.
Eigen::Vector3d light_direction_of(const Eigen::Affine3d& T_world_node);

}  // namespace synth
