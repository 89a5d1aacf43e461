#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene/scene.h"
#include "synth/scene/scene_motion.h"
#include "synth/scene/shared_mesh.h"

namespace synth {

/// A mesh instance with its vertices in the world-space geometry's coordinates, unless they are
/// those of a shared mesh.
struct FlatMesh {
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  bool is_textured = false;  ///< whether the material has any texture
  int instance = kNone;      ///< index into Scene::instances
  Eigen::Affine3d T_world_mesh = Eigen::Affine3d::Identity();
  float side = 1;                                    ///< -1 if T_world_mesh mirrors, else 1
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, WorldGeometry::origin
  int shared = kNone;                                ///< index into WorldGeometry::shared_meshes
  std::vector<Eigen::Vector3f> positions;  ///< m; padded by one, as Embree reads 16 bytes each
  std::vector<Eigen::Vector3f> normals;
  std::vector<FlatMesh> moments;  ///< states at SceneDuring::moments; empty if it does not move

  bool has_normals() const { return !mesh->normals.empty(); }
  Eigen::Vector3f position(int vertex) const;  ///< m, in the world-space geometry's coordinates
  Eigen::Vector3f normal(int vertex) const;    ///< unit or zero; requires has_normals()
};

/// Returns the mesh's material, or a default one, white and diffuse, if the mesh names none.
const Material& material_of(const Scene& scene, const Mesh& mesh);

/// Throws Error beginning with `place` unless all of a box, m, world, is within vo::kMaxMetres of
/// the origin along each axis: beyond, distances in 32-bit floats overflow, in which rays are
/// traced.
void require_within_world(const Eigen::AlignedBox3d& box, const std::string& place);

/// Throws likewise for the instances of a scene; `place_of` names one by its index.
void require_within_world(const Scene& scene,
                          const std::function<std::string(std::size_t)>& place_of);

/// A scene's triangles without its node hierarchy. All float coordinates are world coordinates
/// minus `origin`, which preserves precision wherever the scene lies: the middle of the scene or,
/// in one wider than 1 km, the median of its vertices, which no stray vertex moves. Refers to the
/// scene, which must outlive it.
struct WorldGeometry {
  const Scene* scene = nullptr;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, world
  std::vector<FlatMesh> meshes;                      ///< each with at least one triangle
  std::vector<SharedMesh> shared_meshes;
  double begin = 0;  ///< s, time of the first moment
  double end = 0;    ///< s, time of the last moment

  /// Returns where a time of the animations, s, lies between `begin` and `end`, clamped to 0 to 1.
  float share_at(double time) const;
};

WorldGeometry flatten(const Scene& scene);

/// Flattens a moving scene. Vertices move linearly from moment to moment.
WorldGeometry flatten(const SceneDuring& during);

/// The moments of a mesh around an instant; both are the mesh itself if it does not move.
struct MomentPair {
  const FlatMesh* before = nullptr;
  const FlatMesh* after = nullptr;
  float share = 0;  ///< fraction of the way from `before` to `after`
};

/// Returns the moments around an instant; `share` is the value of WorldGeometry::share_at.
MomentPair moments_around(const FlatMesh& mesh, float share);

/// Returns the corners of a triangle, m, in the world-space geometry's coordinates. `share` is the
/// value of WorldGeometry::share_at.
std::array<Eigen::Vector3f, 3> corners_of(const FlatMesh& mesh, int triangle, float share = 0);

/// Returns the corners of a triangle, m, world, in double precision; of a mesh that moves, as the
/// scene itself has them.
std::array<Eigen::Vector3d, 3> world_corners(const FlatMesh& mesh, int triangle);

/// Returns the transform from the vertices of the shared mesh that `mesh` shows to the world-space
/// geometry's coordinates.
Eigen::Affine3d T_flat_shared(const WorldGeometry& world, const FlatMesh& mesh);

/// Returns the bounding box of all meshes, m, world.
Eigen::AlignedBox3d visible_bounds(const WorldGeometry& world);

/// The plane of a triangle as one camera sees it, in double precision throughout.
struct DepthPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< world axes, any length
  double offset = 0;                                 ///< eye to plane, m, times |normal|
  double nearest = 0;   ///< m, least depth of the triangle's corners, minus a margin
  double farthest = 0;  ///< m, greatest depth of the corners, plus a margin

  /// Returns the depth, m, at which a ray from the eye that hits the triangle meets its plane, or
  /// nothing if that is beyond the corners' depths, as for a degenerate triangle. `direction` is in
  /// world axes, with component 1 along PlaneView::depth_axis.
  std::optional<double> depth_along(const Eigen::Vector3d& direction) const;
};

/// The viewpoint from which a triangle's depth plane is computed.
struct PlaneView {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();          ///< m, world
  Eigen::Vector3d depth_axis = Eigen::Vector3d::UnitZ();  ///< world axes, depths count along it
  float share = 0;                                        ///< value of WorldGeometry::share_at
};

DepthPlane depth_plane(const FlatMesh& mesh, int triangle, const PlaneView& view);

/// Returns the bounding box of all meshes with lit materials, m, world.
Eigen::AlignedBox3d lit_bounds(const WorldGeometry& world);

}  // namespace synth
