#pragma once

#include <vector>

#include <Eigen/Core>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/scene/world_geometry.h"

/// All in the world-space geometry's coordinates, m.
namespace synth {

/// Distance of a point to the nearest triangle, or `reach` where that is nearer.
float distance_to_surface(const EmbreeScene& embree, const WorldGeometry& world,
                          const Eigen::Vector3f& point, float reach);

/// What a ray from a point hits.
struct ProbeHit {
  float distance = 0;  ///< in lengths of the ray's direction; 0 = nothing
  bool front = false;  ///< the triangle's front, counter-clockwise, though it may have two sides
};

std::vector<ProbeHit> probe(const EmbreeScene& embree, const WorldGeometry& world,
                            const Eigen::Vector3f& point,
                            const std::vector<Eigen::Vector3f>& directions);

/// Whether a surface crosses the straight way between two points.
bool is_blocked(const EmbreeScene& embree, const Eigen::Vector3f& from, const Eigen::Vector3f& to);

}  // namespace synth
