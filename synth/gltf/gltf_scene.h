#pragma once

#include <string>

#include "synth/gltf/gltf.h"
#include "synth/gltf/labelled_scene.h"
#include "synth/gltf_model/gltf_model.h"

namespace synth {

/// Reads the scene that the options select, at rest, with its nodes also where nothing moves. Its
/// instances are those of its nodes, level by level as `scene_nodes` has them, of each node its
/// mesh's primitives in order, if it has instances (EXT_mesh_gpu_instancing) for each of them; its
/// materials are in the order in which the instances first use them. Throws vo::Error.
LabelledScene read_scene(const GltfModel& model, const GltfOptions& options, Notes& notes);

/// Returns the glTF indices of the nodes of the scene that `wanted`, a GltfOptions::scene, selects,
/// level by level. Throws vo::Error if there is none.
std::vector<int> scene_nodes(const GltfModel& model, const std::string& wanted);

}  // namespace synth
