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
  float side = 1;                          ///< -1 where T_world_mesh mirrors
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

/// The box around all that can be seen, m, world.
Eigen::AlignedBox3d visible_bounds(const FlatScene& flat);

/// The plane of a triangle as one camera sees it, in double precision throughout.
struct DepthPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< world axes, any length
  double offset = 0;                                 ///< of the plane from the eye along the normal
  double nearest = 0;   ///< m, least depth of the triangle's corners, less a margin
  double farthest = 0;  ///< m, their greatest, and a margin

  /// Depth, m, at which a ray from the eye that hits the triangle meets its plane; the direction is
  /// 1 along the optical axis, world axes. Nothing where that is beyond the corners' depths, as on
  /// a triangle of no width.
  std::optional<double> depth_along(const Eigen::Vector3d& direction) const;
};

/// `eye` in the world, m; `optical_axis` is unit, world axes.
DepthPlane depth_plane(const FlatMesh& mesh, int triangle, const Eigen::Vector3d& eye,
                       const Eigen::Vector3d& optical_axis);

/// The box around all that is lit, m, world.
Eigen::AlignedBox3d lit_bounds(const FlatScene& flat);

}  // namespace synth
