#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene/scene.h"
#include "synth/scene/scene_motion.h"
#include "synth/scene/shared_mesh.h"

namespace synth {

/// An instance with its vertices where they stand, unless it shares them.
struct FlatMesh {
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  int instance = kNone;  ///< of Scene::instances
  Eigen::Affine3d T_world_mesh = Eigen::Affine3d::Identity();
  float side = 1;                                    ///< -1 where T_world_mesh mirrors
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< WorldGeometry's
  int shared = kNone;                                ///< of WorldGeometry::shared_meshes
  std::vector<Eigen::Vector3f> positions;  ///< and one more: Embree reads 16 bytes at each
  std::vector<Eigen::Vector3f> normals;
  std::vector<FlatMesh> moments;  ///< of a mesh that moves meanwhile: where it stands at each

  bool has_normals() const { return !mesh->normals.empty(); }
  Eigen::Vector3f position(int vertex) const;  ///< m, in the world-space geometry's coordinates
  Eigen::Vector3f normal(int vertex) const;    ///< unit or zero; only of meshes that have them
};

/// What the mesh is made of; glTF's default if it does not say.
const Material& material_of(const Scene& scene, const Mesh& mesh);

/// A scene's triangles without its hierarchy. All float coordinates are the world's less `origin`,
/// the middle of the scene, which keeps their precision wherever the scene stands. Refers to the
/// scene.
struct WorldGeometry {
  const Scene* scene = nullptr;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, world
  std::vector<FlatMesh> meshes;                      ///< each has a triangle
  std::vector<SharedMesh> shared_meshes;
  double begin = 0;  ///< s, of the first moment
  double end = 0;    ///< s, of the last

  /// How far a time of the scene's animations lies from the first moment to the last, 0 to 1.
  float share_at(double time) const;
};

WorldGeometry flatten(const Scene& scene);

/// Vertices that move go straight from moment to moment.
WorldGeometry flatten(const SceneDuring& during);

/// What lies between two moments of a mesh; of one that rests, both are the mesh.
struct MomentPair {
  const FlatMesh* before = nullptr;
  const FlatMesh* after = nullptr;
  float share = 0;  ///< of the way from the one to the other
};

/// `share` is WorldGeometry::share_at.
MomentPair moments_around(const FlatMesh& mesh, float share);

/// Corners of a triangle, m, in the world-space geometry's coordinates. `share` is
/// WorldGeometry::share_at.
std::array<Eigen::Vector3f, 3> corners_of(const FlatMesh& mesh, int triangle, float share = 0);

/// From the vertices of the shared mesh that it shows to the world-space geometry's coordinates.
Eigen::Affine3d T_flat_shared(const WorldGeometry& world, const FlatMesh& mesh);

/// The box around all that can be seen, m, world.
Eigen::AlignedBox3d visible_bounds(const WorldGeometry& world);

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

/// Where a triangle is looked at from.
struct PlaneView {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();            ///< m, world
  Eigen::Vector3d optical_axis = Eigen::Vector3d::UnitZ();  ///< unit, world axes
  float share = 0;                                          ///< WorldGeometry::share_at
};

DepthPlane depth_plane(const FlatMesh& mesh, int triangle, const PlaneView& view);

/// The box around all that is lit, m, world.
Eigen::AlignedBox3d lit_bounds(const WorldGeometry& world);

}  // namespace synth
