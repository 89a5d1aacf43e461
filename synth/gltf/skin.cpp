#include "synth/gltf/skin.h"

#include <cstddef>

#include "synth/gltf_model/accessor.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

void read_set(const GltfModel& model, int joints_accessor, int weights_accessor, std::size_t set,
              const std::string& place, VertexJoints& followed) {
  const auto sets = static_cast<std::size_t>(followed.sets);
  const std::vector<std::uint32_t> joints = read_indices(model.content, joints_accessor, place);
  const auto weights = read_vectors<Eigen::Vector4f>(model.content, weights_accessor,
                                                     place + ": WEIGHTS_" + std::to_string(set));
  for (std::size_t vertex = 0; vertex < weights.size(); ++vertex) {
    const std::size_t slot = vertex * sets + set;
    followed.weights[slot] = weights[vertex];
    for (std::size_t i = 0; i < 4; ++i) {
      followed.joints[slot][i] = static_cast<int>(joints[4 * vertex + i]);
    }
  }
}

void check_and_normalize(VertexJoints& followed, std::size_t joints, const std::string& place) {
  const auto sets = static_cast<std::size_t>(followed.sets);
  for (std::size_t vertex = 0; vertex < followed.weights.size() / sets; ++vertex) {
    float sum = 0;
    for (std::size_t slot = vertex * sets; slot < (vertex + 1) * sets; ++slot) {
      require(followed.weights[slot].minCoeff() >= 0, place, ": vertex ", vertex,
              " has a negative weight, expected 0 or more");
      for (const int joint : followed.joints[slot]) {
        require(joint >= 0 && at(joint) < joints, place, ": vertex ", vertex, " follows joint ",
                joint, ", expected one below the ", joints, " joints of the skin");
      }
      sum += followed.weights[slot].sum();
    }
    if (!(sum > 0)) {
      followed.weights[vertex * sets][0] = 1;
      sum = 1;
    }
    for (std::size_t slot = vertex * sets; slot < (vertex + 1) * sets; ++slot) {
      followed.weights[slot] /= sum;
    }
  }
}

}  // namespace

Skin read_skin(const GltfModel& model, int index, const NodeForest& forest) {
  const tinygltf::Skin& source = model.content.skins[at(index)];
  Skin skin;
  for (const int joint : source.joints) {
    skin.joints.push_back(forest.of_gltf[at(joint)]);
  }
  skin.T_joint_mesh.assign(skin.joints.size(), Eigen::Affine3d::Identity());
  if (source.inverseBindMatrices == kNone ||
      !holds_data(model.content, source.inverseBindMatrices)) {
    return skin;
  }
  const std::string place = model.place("skins", index) + ": inverseBindMatrices";
  const std::vector<float> numbers = read_numbers(model.content, source.inverseBindMatrices, place);
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const Eigen::Matrix4f matrix = Eigen::Map<const Eigen::Matrix4f>(numbers.data() + 16 * i);
    require(matrix.row(3).isApprox(Eigen::RowVector4f(0, 0, 0, 1), 1e-5F), place,
            ": the last row of element ", i, " is not 0 0 0 1, expected an affine transform");
    skin.T_joint_mesh[i].affine() = matrix.topRows<3>().cast<double>();
  }
  return skin;
}

VertexJoints read_joints(const GltfModel& model, const tinygltf::Primitive& primitive,
                         std::size_t joints, const std::string& place) {
  VertexJoints followed;
  const auto attribute = [&](const char* name) {
    const auto found = primitive.attributes.find(name + std::to_string(followed.sets));
    return found == primitive.attributes.end() ? kNone : found->second;
  };
  while (attribute("JOINTS_") != kNone && attribute("WEIGHTS_") != kNone) {
    ++followed.sets;
  }
  if (followed.sets == 0) {
    return followed;
  }
  const auto sets = static_cast<std::size_t>(followed.sets);
  const std::size_t vertices =
      model.content.accessors[at(primitive.attributes.at("JOINTS_0"))].count;
  followed.joints.resize(vertices * sets);
  followed.weights.resize(vertices * sets);
  for (std::size_t set = 0; set < sets; ++set) {
    const std::string number = std::to_string(set);
    read_set(model, primitive.attributes.at("JOINTS_" + number),
             primitive.attributes.at("WEIGHTS_" + number), set, place, followed);
  }
  check_and_normalize(followed, joints, place);
  return followed;
}

}  // namespace synth
