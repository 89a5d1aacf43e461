#include "synth/gltf_check_nodes.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

using Parents = std::vector<std::optional<std::size_t>>;

void check_transform(const JsonObject& node) {
  const std::vector<double> matrix = node.numbers("matrix", 16);  // column by column
  const std::vector<double> rotation = node.numbers("rotation", 4);
  node.numbers("translation", 3);
  node.numbers("scale", 3);
  if (!matrix.empty()) {
    require(!node.has("rotation") && !node.has("translation") && !node.has("scale"), node.place(),
            ": has a matrix and other transforms, expected one kind");
    require(matrix[3] == 0 && matrix[7] == 0 && matrix[11] == 0 && matrix[15] == 1, node.place(),
            ": the last row of matrix is not 0 0 0 1, expected an affine transform");
  }
  require(rotation.empty() || std::any_of(rotation.begin(), rotation.end(),
                                          [](double component) { return component != 0; }),
          node.place(), ": rotation is zero, expected a unit quaternion");
}

std::size_t light_count(const JsonObject& root) {
  const std::optional<JsonObject> extension = root.extension("KHR_lights_punctual");
  if (!extension) {
    return 0;
  }
  const std::vector<JsonObject> lights = extension->objects("lights");
  for (const JsonObject& light : lights) {
    const std::string type = light.required_text("type");
    require(type == "point" || type == "directional" || type == "spot", light.place(), ": type is ",
            type, ", expected point, directional or spot");
    light.numbers("color", 3);
    light.number("intensity");
  }
  return lights.size();
}

void check_nodes(const JsonObject& root, const std::vector<JsonObject>& nodes) {
  const std::size_t meshes = root.objects("meshes").size();
  const std::size_t skins = root.objects("skins").size();
  const std::size_t cameras = root.objects("cameras").size();
  const std::size_t lights = light_count(root);
  for (const JsonObject& node : nodes) {
    node.index("mesh", meshes);
    node.index("skin", skins);
    node.index("camera", cameras);
    if (const auto light = node.extension("KHR_lights_punctual")) {
      light->required_index("light", lights);
    }
    check_transform(node);
  }
}

void check_skins(const JsonObject& root, std::size_t nodes) {
  const std::size_t accessors = root.objects("accessors").size();
  for (const JsonObject& skin : root.objects("skins")) {
    skin.index("skeleton", nodes);
    skin.index("inverseBindMatrices", accessors);
    skin.indices("joints", nodes);
  }
}

Parents find_parents(const std::vector<JsonObject>& nodes) {
  Parents parents(nodes.size());
  for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
    for (const std::size_t child : nodes[parent].indices("children", nodes.size())) {
      require(child != parent, nodes[parent].place(), ": is its own child, expected a tree");
      require(!parents[child], nodes[child].place(), ": is a child of nodes[",
              parents[child].value_or(0), "] and of nodes[", parent, "], expected one parent");
      parents[child] = parent;
    }
  }
  return parents;
}

/// As every node has at most one parent, the nodes that no root leads to lie on or below a cycle.
void check_for_cycles(const std::vector<JsonObject>& nodes, const Parents& parents) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!parents[i]) {
      open.push_back(i);
    }
  }
  std::vector<bool> reached(nodes.size(), false);
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    reached[node] = true;
    const std::vector<std::size_t> children = nodes[node].indices("children", nodes.size());
    open.insert(open.end(), children.begin(), children.end());
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    require(reached[i], nodes[i].place(), ": is in or below a cycle of children, expected a tree");
  }
}

void check_scenes(const JsonObject& root, const Parents& parents) {
  const std::vector<JsonObject> scenes = root.objects("scenes");
  for (const JsonObject& scene : scenes) {
    std::vector<bool> listed(parents.size(), false);
    for (const std::size_t node : scene.indices("nodes", parents.size())) {
      require(!parents[node], scene.place(), ": nodes[", node, "] is a child of nodes[",
              parents[node].value_or(0), "], expected nodes without parent");
      require(!listed[node], scene.place(), ": lists nodes[", node, "] twice, expected it once");
      listed[node] = true;
    }
  }
  root.index("scene", scenes.size());
}

}  // namespace

void check_node_graph(const JsonObject& root) {
  const std::vector<JsonObject> nodes = root.objects("nodes");
  check_nodes(root, nodes);
  check_skins(root, nodes.size());
  const Parents parents = find_parents(nodes);
  check_for_cycles(nodes, parents);
  check_scenes(root, parents);
}

}  // namespace synth
