#pragma once

#include <vector>

#include "synth/gltf_model/gltf_model.h"
#include "synth/scene/motion.h"

namespace synth {

/// All nodes of a file, parents first.
struct NodeForest {
  std::vector<MotionNode> nodes;
  std::vector<int> of_gltf;  ///< index into `nodes` by glTF's
};

/// The nodes must form trees, as check_document makes sure.
NodeForest read_nodes(const tinygltf::Model& model);

/// The nodes below these, and they, level by level in the document's order: glTF's indices.
std::vector<int> nodes_below(const tinygltf::Model& model, const std::vector<int>& roots);

/// The nodes that no other has as a child.
std::vector<int> root_nodes(const tinygltf::Model& model);

}  // namespace synth
