#pragma once

#include <Eigen/Geometry>
#include <tiny_gltf.h>

#include "synth/scene/scene.h"

namespace synth {

/// A light of KHR_lights_punctual, which shines along -z of its node. The direction is zero where
/// the node has none.
Light place_light(const tinygltf::Light& source, const Eigen::Affine3d& T_world_node);

/// glTF's camera looks along -z of its node and has y up; scale does not change it.
SceneCamera place_camera(const tinygltf::Camera& source, const Eigen::Affine3d& T_world_node);

}  // namespace synth
