#pragma once

#include <string>
#include <vector>

#include "synth/gltf/gltf.h"
#include "synth/gltf_model/gltf_model.h"
#include "synth/gltf_model/nodes.h"

namespace synth {

/// Reads a glTF skin. Throws vo::Error if an inverse bind matrix is not affine.
Skin read_skin(const GltfModel& model, int index, const NodeForest& forest);

/// Reads the joints and weights of a primitive's vertices; no sets if it has none. `joints` is the
/// number of joints of its skin. The weights of a vertex are scaled to sum to 1; a vertex without
/// weight follows its first joint. Throws vo::Error beginning with `place` for joints out of range
/// and negative weights.
VertexJoints read_joints(const GltfModel& model, const tinygltf::Primitive& primitive,
                         std::size_t joints, const std::string& place);

}  // namespace synth
