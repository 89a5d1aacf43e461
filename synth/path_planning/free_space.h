#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "synth/ray_tracing/surface_tracer.h"

namespace synth {

/// What rays into all directions from a place say about it.
struct Surroundings {
  double hit_share = 0;     ///< of the rays that hit something
  double level_share = 0;   ///< of those not far from level or downwards that hit something
  double front_share = 0;   ///< of the hits: triangles that show their fronts
  double far_distance = 0;  ///< m; three quarters of the hits are nearer
};

/// Where a camera can be in a scene. The tracer must outlive it.
class FreeSpace {
 public:
  explicit FreeSpace(const SurfaceTracer& tracer);

  /// Distance to the nearest surface, m, or `reach` where that is less.
  double clearance(const Eigen::Vector3d& p_world, double reach) const;

  /// Whether a ball of this radius, m, can go straight from one place to the other.
  bool is_free(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) const;

  /// Whether a surface crosses the straight way.
  bool is_crossed(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  /// Distance along a unit direction to a surface, m; 0 = there is none.
  double distance_along(const Eigen::Vector3d& p_world, const Eigen::Vector3d& direction) const;

  Surroundings look_around(const Eigen::Vector3d& p_world) const;

  /// A place beside a surface, m, world: off a triangle's front, a share of the way to what is
  /// opposite (or of half of the scene). The shares, in [0, 1), choose the triangle, the point on
  /// it, and the place on the way.
  Eigen::Vector3d beside_surface(const Eigen::Vector4d& shares) const;

  Eigen::AlignedBox3d bounds() const { return bounds_; }  ///< m, world

 private:
  Eigen::Vector3f flat_point(const Eigen::Vector3d& p_world) const;

  const SurfaceTracer& tracer_;
  Eigen::AlignedBox3d bounds_;
  std::vector<std::size_t> triangles_before_;  ///< in the meshes before each mesh, and in all
  std::vector<Eigen::Vector3f> directions_;    ///< unit, evenly over the sphere
};

}  // namespace synth
