#include "synth/scene/shared_mesh.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/LU>

namespace synth {
namespace {

// A copied triangle takes 0.17 kB. Rays through Embree's instances take up to a quarter longer, and
// an instance of a few triangles takes as much memory as a copy of them.
constexpr std::size_t kLeastTriangles = 64;            // in a shared mesh
constexpr std::size_t kLeastTrianglesSaved = 100'000;  // in all its instances but one

/// Returns whether a matrix can be inverted accurately and mirrors if and only if `side` does: its
/// columns must have a moderate length and span enough of the volume that orthogonal ones would.
bool is_upright(const Eigen::Matrix3d& A, const Eigen::Matrix3d& side) {
  constexpr double kLeastScale = 1e-6;
  constexpr double kMostScale = 1e6;
  constexpr double kLeastShare = 0.1;  // fraction of the volume that orthogonal columns span
  const Eigen::RowVector3d scale = A.colwise().norm();
  const double volume = side.determinant() < 0 ? -A.determinant() : A.determinant();
  return scale.minCoeff() >= kLeastScale && scale.maxCoeff() <= kMostScale &&
         volume >= kLeastShare * scale.prod();
}

Eigen::Matrix3d axes_of(const Scene& scene, std::size_t instance) {
  return scene.instances[instance].T_world_mesh.linear();
}

/// Returns whether an instance is upright at all moments and, as vertices move linearly, halfway.
bool stays_upright(const std::vector<Scene>& moments, std::size_t instance) {
  const Eigen::Matrix3d first = axes_of(moments.front(), instance);
  bool is_sound = is_upright(first, first);
  for (std::size_t i = 1; i < moments.size(); ++i) {
    const Eigen::Matrix3d axes = axes_of(moments[i], instance);
    const Eigen::Matrix3d half_way = (axes_of(moments[i - 1], instance) + axes) / 2;
    is_sound = is_sound && is_upright(axes, first) && is_upright(half_way, first);
  }
  return is_sound;
}

/// Returns for each mesh whether copying it for each instance would cost more than sharing it.
std::vector<bool> worth_sharing(const Scene& scene) {
  std::vector<std::size_t> uses(scene.meshes.size(), 0);
  for (const Instance& instance : scene.instances) {
    if (instance.mesh != kNone) {
      ++uses[instance.mesh];
    }
  }
  std::vector<bool> worth;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const std::size_t triangles = scene.meshes[i].triangles.size();
    worth.push_back(uses[i] > 1 && triangles >= kLeastTriangles &&
                    (uses[i] - 1) * triangles >= kLeastTrianglesSaved);
  }
  return worth;
}

}  // namespace

SharedMesh shared_mesh(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& position : mesh.positions) {
    box.extend(position.cast<double>());
  }
  SharedMesh shared{.mesh = &mesh, .centre = box.center(), .positions = {}};
  shared.positions.resize(mesh.positions.size() + 1, Eigen::Vector3f::Zero());
  std::transform(mesh.positions.begin(), mesh.positions.end(), shared.positions.begin(),
                 [&](const Eigen::Vector3f& position) -> Eigen::Vector3f {
                   return (position.cast<double>() - shared.centre).cast<float>();
                 });
  return shared;
}

std::vector<bool> sharing_instances(const Scene& scene, const std::vector<Scene>& moments) {
  const std::vector<bool> worth = worth_sharing(scene);
  std::vector<bool> sharing(scene.instances.size(), false);
  for (std::size_t i = 0; i < sharing.size(); ++i) {
    const int mesh = scene.instances[i].mesh;
    if (mesh != kNone && worth[mesh]) {
      const Eigen::Matrix3d axes = axes_of(scene, i);
      sharing[i] = moments.empty() ? is_upright(axes, axes) : stays_upright(moments, i);
    }
  }
  return sharing;
}

}  // namespace synth
