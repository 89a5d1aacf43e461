#pragma once

#include <vector>

#include <Eigen/Core>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/scene/world_geometry.h"

/// All points in this header are in the world-space geometry's coordinates, m.
namespace synth {

/// Returns the distance, m, from a point to the nearest triangle, but at most `reach`.
float distance_to_surface(const EmbreeScene& embree, const WorldGeometry& world,
                          const Eigen::Vector3f& point, float reach);

/// The nearest hit of a ray from a point.
struct ProbeHit {
  float distance = 0;  ///< in lengths of the ray's direction; 0 = no hit
  bool front = false;  ///< whether the triangle's counter-clockwise (front) side was hit
};

std::vector<ProbeHit> probe(const EmbreeScene& embree, const WorldGeometry& world,
                            const Eigen::Vector3f& point,
                            const std::vector<Eigen::Vector3f>& directions);

/// Returns whether a surface crosses the line segment between two points.
bool is_blocked(const EmbreeScene& embree, const Eigen::Vector3f& from, const Eigen::Vector3f& to);

}  // namespace synth
