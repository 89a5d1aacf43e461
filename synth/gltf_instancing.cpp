#include "synth/gltf_instancing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "synth/gltf_accessor.h"
#include "synth/gltf_check_buffers.h"
#include "synth/gltf_rotation.h"
#include "synth/motion.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

constexpr const char* kName = "EXT_mesh_gpu_instancing";
constexpr std::array kAttributes = {"TRANSLATION", "ROTATION", "SCALE"};

/// Rotations may be normalised bytes or shorts.
void check_attribute(const JsonObject& accessor, const std::string& name,
                     const std::string& place) {
  constexpr std::size_t kByte = 5120;
  constexpr std::size_t kShort = 5122;
  const bool is_rotation = name == kAttributes[1];
  require_element_type(accessor, is_rotation ? "VEC4" : "VEC3", place);
  const std::size_t component = accessor.required_whole_number("componentType");
  const bool is_short = component == kByte || component == kShort;
  if (!is_rotation || !is_short || !accessor.flag("normalized").value_or(false)) {
    require_float_components(accessor, place);
  }
}

void check_attributes(const JsonObject& attributes, const std::vector<JsonObject>& accessors) {
  std::optional<std::size_t> instances;
  for (const std::string name : kAttributes) {
    const std::optional<std::size_t> index = attributes.index(name, accessors.size());
    if (!index) {
      continue;
    }
    const std::string place = attributes.place() + ": " + name;
    check_attribute(accessors[*index], name, place);
    const std::size_t count = accessors[*index].required_whole_number("count");
    require(instances.value_or(count) == count, place, " has ", count, " elements, expected ",
            instances.value_or(0), " as the other attributes have");
    instances = count;
  }
  require(instances.has_value(), attributes.place(),
          ": has none of TRANSLATION, ROTATION and SCALE, expected one or more");
}

/// As many as there are instances; none where the file does not say.
template <typename Vector>
std::vector<Vector> read_attribute(GltfReading& reading, const tinygltf::Node& node,
                                   const std::string& name, const std::string& place) {
  const tinygltf::Value& attributes = node.extensions.at(kName).Get("attributes");
  if (!attributes.Has(name)) {
    return {};
  }
  const int accessor = attributes.Get(name).GetNumberAsInt();
  const tinygltf::Model& model = reading.model.content;
  const std::size_t count = model.accessors[static_cast<std::size_t>(accessor)].count;
  reading.budget.take(count * (sizeof(Eigen::Affine3d) + sizeof(MotionNode)), place);
  return read_vectors<Vector>(model, accessor, place + ": " + name);
}

Eigen::Quaterniond rotation_of(const Eigen::Vector4f& xyzw, std::size_t index,
                               const std::string& place) {
  require(is_nearly_unit(xyzw), place, ": ROTATION ", index,
          " is not of length 1, expected a unit quaternion");
  return Eigen::Quaterniond(xyzw.cast<double>()).normalized();
}

}  // namespace

void check_instancing(const JsonObject& root) {
  const std::vector<JsonObject> accessors = root.objects("accessors");
  for (const JsonObject& node : root.objects("nodes")) {
    if (const auto instancing = node.extension(kName)) {
      check_attributes(instancing->required_object("attributes"), accessors);
    }
  }
}

bool is_instancing(const tinygltf::Node& node) {
  return node.extensions.count(kName) > 0;
}

std::vector<Eigen::Affine3d> read_instancing(GltfReading& reading, const tinygltf::Node& node,
                                             const std::string& place) {
  const auto translations = read_attribute<Eigen::Vector3f>(reading, node, kAttributes[0], place);
  const auto rotations = read_attribute<Eigen::Vector4f>(reading, node, kAttributes[1], place);
  const auto scales = read_attribute<Eigen::Vector3f>(reading, node, kAttributes[2], place);
  std::vector<Eigen::Affine3d> instances(
      std::max({translations.size(), rotations.size(), scales.size()}),
      Eigen::Affine3d::Identity());
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (!translations.empty()) {
      instances[i].translate(translations[i].cast<double>());
    }
    if (!rotations.empty()) {
      instances[i].rotate(rotation_of(rotations[i], i, place));
    }
    if (!scales.empty()) {
      instances[i].scale(scales[i].cast<double>());
    }
  }
  return instances;
}

}  // namespace synth
