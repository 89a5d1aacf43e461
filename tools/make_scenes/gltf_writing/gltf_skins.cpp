#include "tools/make_scenes/gltf_writing/gltf_skins.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace scenes {
namespace {

void write_bytes(std::string& bytes, const std::array<int, 4>& values) {
  for (const int value : values) {
    bytes.push_back(static_cast<char>(static_cast<std::uint8_t>(value)));
  }
}

/// Returns the matrices from the mesh to each joint in the pose that they are bound in.
int write_binds(Document& document, const Skin& skin) {
  std::string& bytes = document.views[binds];
  const std::size_t offset = bytes.size();
  for (const Eigen::Vector3d& joint : skin.joints_in_mesh) {
    const Eigen::Matrix4d T_joint_mesh = Eigen::Affine3d(Eigen::Translation3d(-joint)).matrix();
    for (const double x : T_joint_mesh.reshaped()) {
      write_float(bytes, x, kGrid);
    }
  }
  return add_accessor(document, binds, offset, skin.joints_in_mesh.size(),
                      {{"componentType", kFloat}, {"type", "MAT4"}});
}

}  // namespace

void add_joints(Document& document, const Shape& shape, Json& attributes) {
  constexpr int kWhole = 255;
  const std::size_t joints_offset = document.views[joints].size();
  const std::size_t weights_offset = document.views[weights].size();
  for (const VertexJoints& vertex : shape.joints) {
    const int weight = static_cast<int>(std::floor(vertex.weight * kWhole + 0.5));
    write_bytes(document.views[joints],
                {weight > 0 ? vertex.first : 0, weight < kWhole ? vertex.second : 0, 0, 0});
    write_bytes(document.views[weights], {weight, kWhole - weight, 0, 0});
  }
  attributes["JOINTS_0"] = add_accessor(document, joints, joints_offset, shape.joints.size(),
                                        {{"componentType", kUnsignedByte}, {"type", "VEC4"}});
  attributes["WEIGHTS_0"] =
      add_accessor(document, weights, weights_offset, shape.joints.size(),
                   {{"componentType", kUnsignedByte}, {"normalized", true}, {"type", "VEC4"}});
}

void add_skins(Document& document, const Model& model) {
  for (const Skin& skin : model.skins) {
    document.json["skins"].push_back({{"name", skin.name},
                                      {"joints", skin.joints},
                                      {"inverseBindMatrices", write_binds(document, skin)}});
  }
}

}  // namespace scenes
