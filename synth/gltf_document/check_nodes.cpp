#include "synth/gltf_document/check_nodes.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vo/core/error.h"
#include "vo/geometry/unit_quaternion.h"

namespace synth {
namespace {

using vo::require;

void check_transform(const JsonObject& node) {
  const std::vector<double> matrix = node.numbers("matrix", 16);  // column-major
  const std::vector<double> rotation = node.numbers("rotation", 4);
  node.numbers("translation", 3);
  node.numbers("scale", 3);
  if (!matrix.empty()) {
    require(!node.has("rotation") && !node.has("translation") && !node.has("scale"), node.place(),
            ": has a matrix and other transforms, expected one kind");
    require(matrix[3] == 0 && matrix[7] == 0 && matrix[11] == 0 && matrix[15] == 1, node.place(),
            ": the last row of matrix is not 0 0 0 1, expected an affine transform");
  }
  require_unit_rotation(rotation, node);
}

void check_spot(const JsonObject& light) {
  const JsonObject spot = light.required_object("spot");
  const double outer = spot.number("outerConeAngle").value_or(std::numbers::pi / 4);
  const double inner = spot.number("innerConeAngle").value_or(0);
  require(inner >= 0 && inner < outer && outer <= std::numbers::pi / 2, spot.place(),
          ": its cone angles are ", inner, " and ", outer,
          ", expected 0 <= innerConeAngle < outerConeAngle <= pi / 2");
}

std::size_t check_lights(const JsonObject& root) {
  const std::optional<JsonObject> extension = root.extension("KHR_lights_punctual");
  if (!extension) {
    return 0;
  }
  require(extension->has("lights"), extension->place(), ": has no lights, expected an array");
  const std::vector<JsonObject> lights = extension->objects("lights");
  for (const JsonObject& light : lights) {
    const std::string type = light.required_text("type");
    for (const double channel : light.numbers("color", 3)) {
      require(channel >= 0, light.place(), ": color is negative, expected 0 or more");
    }
    require(light.number("intensity").value_or(1) >= 0, light.place(),
            ": intensity is negative, expected 0 or more");
    const double range = light.number("range").value_or(1);
    require(range > 0, light.place(), ": range is ", range, ", expected more than 0");
    if (type == "spot") {
      check_spot(light);
    }
  }
  return lights.size();
}

double required_positive(const JsonObject& object, const std::string& key) {
  const std::optional<double> number = object.number(key);
  require(number.value_or(0) > 0, object.place(), ": ", key, " is ", number.value_or(0),
          ", expected more than 0");
  return *number;
}

std::size_t check_cameras(const JsonObject& root) {
  const std::vector<JsonObject> cameras = root.objects("cameras");
  for (const JsonObject& camera : cameras) {
    const std::string type = camera.required_text("type");
    require(type == "perspective" || type == "orthographic", camera.place(), ": type is ", type,
            ", expected perspective or orthographic");
    require(camera.has("perspective") != camera.has("orthographic"), camera.place(),
            ": has both or neither of perspective and orthographic, expected one");
    const JsonObject lens = camera.required_object(type);
    const double near = lens.number("znear").value_or(-1);
    if (type == "perspective") {
      required_positive(lens, "yfov");
      required_positive(lens, "znear");
      require(lens.number("aspectRatio").value_or(1) > 0, lens.place(),
              ": aspectRatio is not positive, expected more than 0");
      require(lens.number("zfar").value_or(near + 1) > near, lens.place(),
              ": zfar is not beyond znear, expected a larger one");
    } else {
      require(near >= 0 && required_positive(lens, "zfar") > near, lens.place(), ": znear is ",
              near, ", expected 0 or more and less than zfar");
      require(lens.number("xmag").value_or(0) != 0 && lens.number("ymag").value_or(0) != 0,
              lens.place(), ": xmag or ymag is 0, expected the half width and height");
    }
  }
  return cameras.size();
}

void check_nodes(const JsonObject& root, const std::vector<JsonObject>& nodes) {
  const std::size_t meshes = root.objects("meshes").size();
  const std::size_t skins = root.objects("skins").size();
  const std::size_t cameras = check_cameras(root);
  const std::size_t lights = check_lights(root);
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

/// Throws if nodes that have at most one parent form a cycle: if no root reaches one of them.
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

void require_unit_rotation(const std::vector<double>& rotation, const JsonObject& object) {
  require(
      rotation.empty() || vo::is_nearly_unit(Eigen::Map<const Eigen::Vector4d>(rotation.data())),
      object.place(), ": rotation is not of length 1, expected a unit quaternion");
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

void check_node_graph(const JsonObject& root) {
  const std::vector<JsonObject> nodes = root.objects("nodes");
  check_nodes(root, nodes);
  const Parents parents = find_parents(nodes);
  check_for_cycles(nodes, parents);
  check_scenes(root, parents);
}

}  // namespace synth
