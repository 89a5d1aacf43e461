#include "synth/flat_scene.h"

#include <algorithm>
#include <array>

#include <Eigen/LU>

#include "synth/cofactors.h"

namespace synth {
namespace {

const Material kDefaultMaterial;  // glTF's, of a mesh without one

Eigen::AlignedBox3d bounds(const FlatMesh& flat) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& position : flat.mesh->positions) {
    box.extend(flat.T_world_mesh * position.cast<double>());
  }
  return box;
}

void place_vertices(const Eigen::Vector3d& origin, FlatMesh& flat) {
  const Mesh& mesh = *flat.mesh;
  flat.positions.resize(mesh.positions.size() + 1, Eigen::Vector3f::Zero());
  std::transform(mesh.positions.begin(), mesh.positions.end(), flat.positions.begin(),
                 [&](const Eigen::Vector3f& position) -> Eigen::Vector3f {
                   const Eigen::Vector3d p_world = flat.T_world_mesh * position.cast<double>();
                   return (p_world - origin).cast<float>();
                 });
  const Eigen::Matrix3d N = cofactors(flat.T_world_mesh.linear());
  flat.normals.resize(mesh.normals.size());
  std::transform(mesh.normals.begin(), mesh.normals.end(), flat.normals.begin(),
                 [&](const Eigen::Vector3f& normal) -> Eigen::Vector3f {
                   return (N * normal.cast<double>()).normalized().cast<float>();
                 });
}

}  // namespace

FlatScene flatten(const Scene& scene) {
  FlatScene flat;
  flat.scene = &scene;
  Eigen::AlignedBox3d box;
  for (const Instance& instance : scene.instances) {
    if (instance.mesh == kNone || scene.meshes[instance.mesh].triangles.empty()) {
      continue;
    }
    FlatMesh& added = flat.meshes.emplace_back();
    added.mesh = &scene.meshes[instance.mesh];
    added.instance = static_cast<int>(&instance - scene.instances.data());
    const int material = added.mesh->material;
    added.material = material == kNone ? &kDefaultMaterial : &scene.materials[material];
    added.T_world_mesh = instance.T_world_mesh;
    added.side = instance.T_world_mesh.linear().determinant() < 0 ? -1.0F : 1.0F;
    box.extend(bounds(added));
  }
  if (!box.isEmpty()) {
    flat.origin = box.center();
  }
  for (FlatMesh& mesh : flat.meshes) {
    place_vertices(flat.origin, mesh);
  }
  return flat;
}

Eigen::AlignedBox3d visible_bounds(const FlatScene& flat) {
  Eigen::AlignedBox3d box;
  for (const FlatMesh& mesh : flat.meshes) {
    box.extend(bounds(mesh));
  }
  return box;
}

DepthPlane depth_plane(const FlatMesh& mesh, int triangle, const Eigen::Vector3d& eye,
                       const Eigen::Vector3d& optical_axis) {
  constexpr double kTolerance = 1e-6;      // relative; the hit was found in single precision
  std::array<Eigen::Vector3d, 3> corners;  // from the eye, m
  Eigen::Vector3d depths;
  for (int i = 0; i < 3; ++i) {
    const int vertex = mesh.mesh->triangles[triangle][i];
    corners[i] = mesh.T_world_mesh * mesh.mesh->positions[vertex].cast<double>() - eye;
    depths[i] = corners[i].dot(optical_axis);
  }
  const double margin = kTolerance * depths.cwiseAbs().maxCoeff();
  DepthPlane plane;
  plane.normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  plane.offset = plane.normal.dot(corners[0]);
  plane.nearest = depths.minCoeff() - margin;
  plane.farthest = depths.maxCoeff() + margin;
  return plane;
}

std::optional<double> DepthPlane::depth_along(const Eigen::Vector3d& direction) const {
  const double depth = offset / normal.dot(direction);
  return depth >= nearest && depth <= farthest ? std::optional(depth) : std::nullopt;
}

Eigen::AlignedBox3d lit_bounds(const FlatScene& flat) {
  Eigen::AlignedBox3d box;
  for (const FlatMesh& mesh : flat.meshes) {
    if (!mesh.material->unlit) {
      box.extend(bounds(mesh));
    }
  }
  return box;
}

}  // namespace synth
