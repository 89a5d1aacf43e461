#include "synth/scene/deformable_mesh.h"

#include <algorithm>
#include <cstddef>

#include "synth/scene/cofactors.h"

namespace synth {
namespace {

template <typename Vector>
void add_displacements(const std::vector<Eigen::Vector3f>& displacements, float weight,
                       std::vector<Vector>& vectors) {
  if (weight == 0 || displacements.empty()) {
    return;
  }
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    vectors[i].template head<3>() += weight * displacements[i];
  }
}

/// Scales a direction's xyz to unit length; a zero direction becomes `before`.
template <typename Vector>
void normalize(const Vector& before, Vector& direction) {
  const float length = direction.template head<3>().stableNorm();
  if (length > 0) {
    direction.template head<3>() /= length;
  } else {
    direction = before;
  }
}

template <typename Vector>
void normalize_all(const std::vector<Vector>& before, std::vector<Vector>& directions) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    normalize(before[i], directions[i]);
  }
}

Eigen::Affine3d blend(const VertexJoints& followed, std::size_t vertex,
                      const std::vector<Eigen::Affine3d>& T_frame_mesh) {
  Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
  const auto sets = static_cast<std::size_t>(followed.sets);
  for (std::size_t set = vertex * sets; set < (vertex + 1) * sets; ++set) {
    for (int i = 0; i < 4; ++i) {
      const double weight = followed.weights[set][i];
      const int joint = followed.joints[set][static_cast<std::size_t>(i)];
      sum += weight * T_frame_mesh[static_cast<std::size_t>(joint)].affine();
    }
  }
  Eigen::Affine3d T = Eigen::Affine3d::Identity();
  T.affine() = sum;
  return T;
}

}  // namespace

void morph(const MeshShape& shape, const std::vector<float>& weights, Mesh& mesh) {
  mesh.positions = shape.positions;
  mesh.normals = shape.normals;
  mesh.tangents = shape.tangents;
  for (std::size_t i = 0; i < std::min(weights.size(), shape.targets.size()); ++i) {
    add_displacements(shape.targets[i].positions, weights[i], mesh.positions);
    add_displacements(shape.targets[i].normals, weights[i], mesh.normals);
    add_displacements(shape.targets[i].tangents, weights[i], mesh.tangents);
  }
  if (!shape.targets.empty()) {
    normalize_all(shape.normals, mesh.normals);
    normalize_all(shape.tangents, mesh.tangents);
  }
}

void deform(const VertexJoints& followed, const std::vector<Eigen::Affine3d>& T_frame_mesh,
            Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Eigen::Affine3d T = blend(followed, i, T_frame_mesh);
    mesh.positions[i] = (T * mesh.positions[i].cast<double>()).cast<float>();
    if (!mesh.normals.empty()) {
      const Eigen::Vector3f before = mesh.normals[i];
      mesh.normals[i] = (cofactors(T.linear()) * before.cast<double>()).cast<float>();
      normalize(before, mesh.normals[i]);
    }
    if (!mesh.tangents.empty()) {
      const Eigen::Vector4f before = mesh.tangents[i];
      mesh.tangents[i].head<3>() = (T.linear() * before.head<3>().cast<double>()).cast<float>();
      normalize(before, mesh.tangents[i]);
    }
  }
}

}  // namespace synth
