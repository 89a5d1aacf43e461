#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "synth/ray_tracing/surface_tracer.h"

namespace synth {

/// Statistics of rays cast from a position in all directions.
struct Surroundings {
  double hit_share = 0;     ///< share of all rays that hit a surface
  double level_share = 0;   ///< share of the rays below 30 degrees' elevation that hit a surface
  double front_share = 0;   ///< share of the hits that are on a triangle's front
  double far_distance = 0;  ///< m, upper quartile of the distances to the hits
};

/// Queries of a scene's free space, where a camera can be. The tracer must outlive it.
class FreeSpace {
 public:
  explicit FreeSpace(const SurfaceTracer& tracer);

  /// Returns the distance to the nearest surface, m, or `reach` where that is less.
  double clearance(const Eigen::Vector3d& p_world, double reach) const;

  /// Returns whether a ball of this radius, m, can move straight from one position to another.
  bool is_free(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) const;

  /// Returns whether a surface crosses the line segment between two positions.
  bool is_crossed(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  /// Returns the distance along a unit direction to the first surface, m; 0 = there is none.
  double distance_along(const Eigen::Vector3d& p_world, const Eigen::Vector3d& direction) const;

  Surroundings look_around(const Eigen::Vector3d& p_world) const;

  /// Returns a position, m, world, in front of a triangle: a share of the way to the opposite
  /// surface (or of half of the scene's diagonal). The shares, in [0, 1), choose the triangle, the
  /// point on it (two of them) and the share of the way.
  Eigen::Vector3d beside_surface(const Eigen::Vector4d& shares) const;

  Eigen::AlignedBox3d bounds() const { return bounds_; }  ///< m, world; all visible surfaces

 private:
  Eigen::Vector3f flat_point(const Eigen::Vector3d& p_world) const;

  const SurfaceTracer& tracer_;
  Eigen::AlignedBox3d bounds_;
  std::vector<std::size_t> triangles_before_;  ///< number of triangles before each mesh, and in all
  std::vector<Eigen::Vector3f> directions_;    ///< unit ray directions, evenly over the sphere
};

}  // namespace synth
