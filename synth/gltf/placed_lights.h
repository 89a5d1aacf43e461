#pragma once

#include <Eigen/Geometry>
#include <tiny_gltf.h>

#include "synth/scene/scene.h"

namespace synth {

/// Returns a light of KHR_lights_punctual in the world, which shines along its node's -z axis. The
/// direction of a directional or spot light is zero if the node's z axis is zero. In a file whose
/// lengths are taken times `scale`, its range is longer by it and its intensity greater by its
/// square, so that it lights the surfaces as before.
Light place_light(const tinygltf::Light& source, const Eigen::Affine3d& T_world_node, double scale);

/// Returns the factor of a light's intensity in a file whose lengths are taken times `scale`.
float intensity_unit(LightKind kind, double scale);

/// Returns the colour of a light of KHR_lights_punctual, and its intensity as `place_light` has it.
Brightness brightness_of(const tinygltf::Light& source, double scale);

/// Returns a glTF camera in the world, which looks along its node's -z axis with +y up.
SceneCamera place_camera(const tinygltf::Camera& source, const Eigen::Affine3d& T_world_node);

}  // namespace synth
