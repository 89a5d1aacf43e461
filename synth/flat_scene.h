#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene.h"

namespace synth {

/// An instance with its vertices where they stand. The normals are unit or zero; none if the mesh
/// has none.
struct FlatMesh {
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  int instance = kNone;  ///< of Scene::instances
  Eigen::Affine3d T_world_mesh = Eigen::Affine3d::Identity();
  std::vector<Eigen::Vector3f> positions;  ///< and one more: Embree reads 16 bytes at each
  std::vector<Eigen::Vector3f> normals;
};

/// A scene's triangles without its hierarchy. All float coordinates are the world's less `origin`,
/// the middle of the scene, which keeps their precision wherever the scene stands. Refers to the
/// scene.
struct FlatScene {
  const Scene* scene = nullptr;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, world
  std::vector<FlatMesh> meshes;                      ///< each has a triangle
};

FlatScene flatten(const Scene& scene);

/// The scene's lights in the flat scene's coordinates, m.
std::vector<Eigen::Vector3f> light_positions(const FlatScene& flat);

/// The box around all that can be seen, m, world.
Eigen::AlignedBox3d visible_bounds(const FlatScene& flat);

/// In the world. The direction is 1 along the optical axis, which is unit.
struct DepthRay {
  Eigen::Vector3d eye;  ///< m
  Eigen::Vector3d direction;
  Eigen::Vector3d optical_axis;
};

/// Depth, m, at which a ray that hits a triangle meets its plane, in double precision throughout.
/// Nothing where that is beyond the depths of the triangle's corners, as on one of no width.
std::optional<double> depth_of_plane(const FlatMesh& mesh, int triangle, const DepthRay& ray);

/// The box around all that is lit, m, world.
Eigen::AlignedBox3d lit_bounds(const FlatScene& flat);

}  // namespace synth
