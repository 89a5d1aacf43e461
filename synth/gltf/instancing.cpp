#include "synth/gltf/instancing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "synth/gltf_document/check_instancing.h"
#include "synth/gltf_model/accessor.h"
#include "synth/scene/motion.h"
#include "vo/core/error.h"
#include "vo/geometry/unit_quaternion.h"

namespace synth {
namespace {

using vo::require;

/// Reads an attribute of all instances of a node; empty if the node does not have it.
template <typename Vector>
std::vector<Vector> read_attribute(GltfReading& reading, const tinygltf::Node& node,
                                   const std::string& name, const std::string& place) {
  const tinygltf::Value& attributes = node.extensions.at(kInstancingExtension).Get("attributes");
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
  require(vo::is_nearly_unit(xyzw), place, ": ROTATION ", index,
          " is not of length 1, expected a unit quaternion");
  return Eigen::Quaterniond(xyzw.cast<double>()).normalized();
}

}  // namespace

bool is_instancing(const tinygltf::Node& node) {
  return node.extensions.count(kInstancingExtension) > 0;
}

std::vector<Eigen::Affine3d> read_instancing(GltfReading& reading, const tinygltf::Node& node,
                                             const std::string& place) {
  const auto translations =
      read_attribute<Eigen::Vector3f>(reading, node, kInstancingAttributes[0], place);
  const auto rotations =
      read_attribute<Eigen::Vector4f>(reading, node, kInstancingAttributes[1], place);
  const auto scales =
      read_attribute<Eigen::Vector3f>(reading, node, kInstancingAttributes[2], place);
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
