#pragma once

#include <vector>

#include "synth/gltf_model/gltf_model.h"
#include "synth/scene/motion.h"

namespace synth {

/// All nodes of a glTF file, parents before their children.
struct NodeForest {
  std::vector<MotionNode> nodes;
  std::vector<int> of_gltf;  ///< index into `nodes` by glTF node index
};

/// Reads all nodes of a model, which must form trees, as check_document ensures. With another
/// `scale` than 1 a node of this scale comes first, the parent of all that have none.
NodeForest read_nodes(const tinygltf::Model& model, double scale);

/// Returns the glTF indices of `roots` and all their descendants, level by level in file order.
std::vector<int> nodes_below(const tinygltf::Model& model, const std::vector<int>& roots);

/// Returns the glTF indices of the nodes that have no parent.
std::vector<int> root_nodes(const tinygltf::Model& model);

}  // namespace synth
