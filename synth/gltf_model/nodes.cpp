#include "synth/gltf_model/nodes.h"

#include <cmath>
#include <cstddef>

#include "synth/scene/scene.h"

namespace synth {
namespace {

/// Reads a rotation, unchanged if it is nearly unit, so that bounds equal those of other readers.
Eigen::Quaterniond read_rotation(const std::vector<double>& xyzw) {
  constexpr double kNearlyUnit = 1e-3;
  const Eigen::Quaterniond rotation(Eigen::Map<const Eigen::Vector4d>(xyzw.data()));
  return std::abs(rotation.norm() - 1) < kNearlyUnit ? rotation : rotation.normalized();
}

MotionNode read_node(const tinygltf::Model& model, const tinygltf::Node& source) {
  MotionNode node;
  if (!source.translation.empty()) {
    node.translation = Eigen::Map<const Eigen::Vector3d>(source.translation.data());
  }
  if (!source.rotation.empty()) {
    node.rotation = read_rotation(source.rotation);
  }
  if (!source.scale.empty()) {
    node.scale = Eigen::Map<const Eigen::Vector3d>(source.scale.data());
  }
  if (source.matrix.empty()) {
    node.T_parent_node =
        Eigen::Translation3d(node.translation) * node.rotation * Eigen::Scaling(node.scale);
  } else {
    node.T_parent_node.matrix() = Eigen::Map<const Eigen::Matrix4d>(source.matrix.data());
  }
  const std::vector<double> none;
  const std::vector<double>& mesh_weights =
      source.mesh == kNone ? none : model.meshes[at(source.mesh)].weights;
  const std::vector<double>& weights = source.weights.empty() ? mesh_weights : source.weights;
  node.weights.assign(weights.begin(), weights.end());
  return node;
}

}  // namespace

NodeForest read_nodes(const tinygltf::Model& model, double scale) {
  NodeForest forest;
  const int world = scale == 1 ? kNone : 0;
  if (world != kNone) {
    MotionNode whole;
    whole.scale.setConstant(scale);
    whole.T_parent_node = Eigen::Scaling(whole.scale);
    forest.nodes.push_back(whole);
  }
  forest.of_gltf.assign(model.nodes.size(), kNone);
  std::vector<int> parents(model.nodes.size(), kNone);
  for (const int index : nodes_below(model, root_nodes(model))) {
    const tinygltf::Node& source = model.nodes[at(index)];
    MotionNode node = read_node(model, source);
    const int parent = parents[at(index)];
    node.parent = parent == kNone ? world : forest.of_gltf[at(parent)];
    forest.of_gltf[at(index)] = static_cast<int>(forest.nodes.size());
    forest.nodes.push_back(node);
    for (const int child : source.children) {
      parents[at(child)] = index;
    }
  }
  return forest;
}

std::vector<int> nodes_below(const tinygltf::Model& model, const std::vector<int>& roots) {
  std::vector<int> nodes = roots;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::vector<int>& children = model.nodes[at(nodes[i])].children;
    nodes.insert(nodes.end(), children.begin(), children.end());
  }
  return nodes;
}

std::vector<int> root_nodes(const tinygltf::Model& model) {
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) {
      is_child[at(child)] = true;
    }
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i) {
    if (!is_child[i]) {
      roots.push_back(static_cast<int>(i));
    }
  }
  return roots;
}

}  // namespace synth
