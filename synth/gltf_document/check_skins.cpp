#include "synth/gltf_document/check_skins.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "synth/gltf_document/check_buffers.h"
#include "synth/gltf_document/check_nodes.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

/// Numbers of the nodes in depth-first preorder: all descendants directly follow their ancestor.
struct NodeOrder {
  std::vector<std::size_t> root;   ///< root node of each node's tree
  std::vector<std::size_t> first;  ///< each node's own number
  std::vector<std::size_t> last;   ///< greatest number in each node's subtree

  bool leads_to(std::size_t ancestor, std::size_t node) const {
    return first[ancestor] <= first[node] && first[node] <= last[ancestor];
  }
};

NodeOrder order_nodes(const std::vector<JsonObject>& nodes) {
  const Parents parents = find_parents(nodes);
  NodeOrder order;
  order.root.resize(nodes.size());
  order.first.resize(nodes.size());
  order.last.resize(nodes.size());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!parents[i]) {
      open.push_back(i);
    }
  }
  std::vector<std::size_t> visited;
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    order.root[node] = parents[node] ? order.root[*parents[node]] : node;
    order.first[node] = order.last[node] = visited.size();
    visited.push_back(node);
    const std::vector<std::size_t> children = nodes[node].indices("children", nodes.size());
    open.insert(open.end(), children.begin(), children.end());
  }
  for (std::size_t i = visited.size(); i-- > 0;) {
    if (const auto parent = parents[visited[i]]) {
      order.last[*parent] = std::max(order.last[*parent], order.last[visited[i]]);
    }
  }
  return order;
}

struct SkinnedDocument {
  std::vector<JsonObject> accessors, views, nodes;
  NodeOrder order;
  std::vector<std::size_t> skin_roots;  ///< root node of the tree of each skin's joints
  Notes& notes;
};

void check_matrices(const JsonObject& skin, std::size_t joints, const SkinnedDocument& document) {
  const auto matrices = skin.index("inverseBindMatrices", document.accessors.size());
  if (!matrices) {
    return;
  }
  const JsonObject& accessor = document.accessors[*matrices];
  const std::string place = skin.place() + ": inverseBindMatrices";
  require_element_type(accessor, "MAT4", place);
  require_float_components(accessor, place);
  require_packed(accessor, document.views, place, document.notes);
  const std::size_t count = accessor.required_whole_number("count");
  require(count >= joints, place, ": has ", count, " matrices, expected one for each of the ",
          joints, " joints");
}

/// Checks a skin and returns the root node of its joints' tree.
std::size_t checked_root(const JsonObject& skin, const SkinnedDocument& document) {
  const NodeOrder& order = document.order;
  const std::vector<std::size_t> joints = skin.indices("joints", document.nodes.size());
  require(!joints.empty(), skin.place(), ": has no joints, expected at least one");
  require(std::set<std::size_t>(joints.begin(), joints.end()).size() == joints.size(), skin.place(),
          ": names a joint twice, expected each once");
  const auto skeleton = skin.index("skeleton", document.nodes.size());
  for (const std::size_t joint : joints) {
    require(order.root[joint] == order.root[joints.front()], skin.place(), ": nodes[",
            joints.front(), "] and nodes[", joint,
            "] have no root in common, expected joints of one tree");
    require(!skeleton || order.leads_to(*skeleton, joint), skin.place(), ": its skeleton nodes[",
            skeleton.value_or(0), "] does not lead to its joint nodes[", joint,
            "], expected a root of all joints");
  }
  check_matrices(skin, joints.size(), document);
  return order.root[joints.front()];
}

/// Returns "3" for "JOINTS_3" with the prefix "JOINTS_"; nothing for other names.
std::optional<std::string> set_of(const std::string& name, const std::string& prefix) {
  return name.compare(0, prefix.size(), prefix) == 0 ? std::optional(name.substr(prefix.size()))
                                                     : std::nullopt;
}

/// Checks that JOINTS_n come with WEIGHTS_n and are numbered from 0 without a gap.
void check_joints(const JsonObject& primitive) {
  const JsonObject attributes = primitive.required_object("attributes");
  std::size_t sets = 0;
  for (const std::string& name : attributes.keys()) {
    const auto joints = set_of(name, "JOINTS_");
    const auto weights = set_of(name, "WEIGHTS_");
    if (joints || weights) {
      const std::string partner = joints ? "WEIGHTS_" + *joints : "JOINTS_" + *weights;
      require(attributes.has(partner), attributes.place(), ": has ", name, " without ", partner,
              ", expected both");
    }
    sets += joints ? 1 : 0;
  }
  for (std::size_t set = 0; set < sets; ++set) {
    require(attributes.has("JOINTS_" + std::to_string(set)), attributes.place(), ": has ", sets,
            " sets of joints but no JOINTS_", set, ", expected numbers from 0 without a gap");
  }
}

void check_wearer(const JsonObject& node, const std::vector<JsonObject>& meshes) {
  if (!node.has("skin")) {
    return;
  }
  const auto mesh = node.index("mesh", meshes.size());
  require(mesh.has_value(), node.place(), ": has a skin without a mesh, expected both");
  for (const JsonObject& primitive : meshes[*mesh].objects("primitives")) {
    require(primitive.required_object("attributes").has("JOINTS_0"), node.place(),
            ": has a skin, but a primitive of meshes[", *mesh,
            "] has no JOINTS_0, expected joints for all of them");
  }
}

/// Checks that the joints of each skin that a scene shows are in the scene.
void check_scene(const JsonObject& scene, const SkinnedDocument& document) {
  const std::vector<std::size_t> listed = scene.indices("nodes", document.nodes.size());
  const std::set<std::size_t> roots(listed.begin(), listed.end());
  for (std::size_t i = 0; i < document.nodes.size(); ++i) {
    const auto skin = document.nodes[i].index("skin", document.skin_roots.size());
    require(!skin || roots.count(document.order.root[i]) == 0 ||
                roots.count(document.skin_roots[*skin]) > 0,
            scene.place(), ": shows nodes[", i, "] but not the joints of its skin, expected both");
  }
}

}  // namespace

void check_skins(const JsonObject& root, Notes& notes) {
  SkinnedDocument document{
      root.objects("accessors"), root.objects("bufferViews"), root.objects("nodes"), {}, {}, notes};
  document.order = order_nodes(document.nodes);
  for (const JsonObject& skin : root.objects("skins")) {
    document.skin_roots.push_back(checked_root(skin, document));
  }
  const std::vector<JsonObject> meshes = root.objects("meshes");
  for (const JsonObject& mesh : meshes) {
    for (const JsonObject& primitive : mesh.objects("primitives")) {
      check_joints(primitive);
    }
  }
  for (const JsonObject& node : document.nodes) {
    check_wearer(node, meshes);
  }
  for (const JsonObject& scene : root.objects("scenes")) {
    check_scene(scene, document);
  }
}

}  // namespace synth
