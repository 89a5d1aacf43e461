#pragma once

#include <string>

#include "synth/gltf/gltf.h"
#include "synth/gltf_model/gltf_model.h"
#include "synth/scene/scene.h"

namespace synth {

/// Reads the scene that the options select, at rest, with its motion if something moves. Throws
/// vo::Error.
Scene read_scene(const GltfModel& model, const GltfOptions& options, Notes& notes);

/// Returns the glTF indices of the nodes of the scene that `wanted`, a GltfOptions::scene, selects,
/// level by level. Throws vo::Error if there is none.
std::vector<int> scene_nodes(const GltfModel& model, const std::string& wanted);

}  // namespace synth
