#pragma once

#include <string>

#include "synth/gltf/gltf.h"
#include "synth/gltf_model/gltf_model.h"
#include "synth/scene/scene.h"

namespace synth {

/// The scene that the options name, at rest, with its motion if something moves.
Scene read_scene(const GltfModel& model, const GltfOptions& options, Notes& notes);

/// The nodes, by glTF's indices, that GltfOptions::scene names, level by level.
std::vector<int> scene_nodes(const GltfModel& model, const std::string& wanted);

}  // namespace synth
