#pragma once

#include <string>
#include <vector>

#include "synth/gltf/gltf.h"
#include "synth/gltf_model/gltf_model.h"
#include "synth/gltf_model/nodes.h"

namespace synth {

/// A skin of glTF. Throws vo::Error where a matrix is not affine.
Skin read_skin(const GltfModel& model, int index, const NodeForest& forest);

/// The joints and weights of a primitive's vertices, `joints` being how many joints its skin has;
/// without sets if it has none. Weights are scaled to sum to 1; a vertex without weight follows its
/// first joint. Throws vo::Error beginning with `place` for joints out of range and weights below
/// 0.
VertexJoints read_joints(const GltfModel& model, const tinygltf::Primitive& primitive,
                         std::size_t joints, const std::string& place);

}  // namespace synth
