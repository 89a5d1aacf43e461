#include "synth/path_planning/free_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "synth/ray_tracing/embree_scene_probe.h"

namespace synth {
namespace {

constexpr int kDirections = 96;
constexpr float kLevel = 0.5F;  // sine of 30 deg elevation, below which rays count as level

/// Returns unit directions of a Fibonacci lattice (Gonzalez, Measurement of areas on a sphere using
/// Fibonacci lattices, 2010).
std::vector<Eigen::Vector3f> even_directions(int count) {
  std::vector<Eigen::Vector3f> directions;
  for (int i = 0; i < count; ++i) {
    const double y = 1 - (2 * i + 1.0) / count;
    const double radius = std::sqrt(1 - y * y);
    const double angle = 2 * std::numbers::pi * i / std::numbers::phi;
    directions.emplace_back(
        Eigen::Vector3d(radius * std::cos(angle), y, radius * std::sin(angle)).cast<float>());
  }
  return directions;
}

double share(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

FreeSpace::FreeSpace(const SurfaceTracer& tracer)
    : tracer_(tracer),
      bounds_(tracer.bounds()),
      triangles_before_{0},
      directions_(even_directions(kDirections)) {
  for (const FlatMesh& mesh : tracer.world().meshes) {
    triangles_before_.push_back(triangles_before_.back() + mesh.mesh->triangles.size());
  }
}

double FreeSpace::clearance(const Eigen::Vector3d& p_world, double reach) const {
  return distance_to_surface(tracer_.embree(), tracer_.world(), flat_point(p_world),
                             static_cast<float>(reach));
}

/// Advances along the segment as far as the ball around each position is free.
bool FreeSpace::is_free(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                        double radius) const {
  const double length = (to - from).norm();
  const double least_step = radius / 16;
  for (double way = 0; way < length;) {
    const double room = clearance(from + (to - from) * (way / length), radius + length - way);
    if (room < radius) {
      return false;
    }
    way += std::max(room - radius, least_step);
  }
  return clearance(to, 2 * radius) >= radius;
}

bool FreeSpace::is_crossed(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  return is_blocked(tracer_.embree(), flat_point(from), flat_point(to));
}

double FreeSpace::distance_along(const Eigen::Vector3d& p_world,
                                 const Eigen::Vector3d& direction) const {
  return probe(tracer_.embree(), tracer_.world(), flat_point(p_world), {direction.cast<float>()})
      .front()
      .distance;
}

Eigen::Vector3d FreeSpace::beside_surface(const Eigen::Vector4d& shares) const {
  const auto index =
      static_cast<std::size_t>(shares[0] * static_cast<double>(triangles_before_.back()));
  const auto next = std::upper_bound(triangles_before_.begin(), triangles_before_.end(), index);
  const auto mesh_index = static_cast<std::size_t>(next - triangles_before_.begin()) - 1;
  const FlatMesh& mesh = tracer_.world().meshes[mesh_index];
  const std::array<Eigen::Vector3f, 3> corners =
      corners_of(mesh, static_cast<int>(index - triangles_before_[mesh_index]));
  const double root = std::sqrt(shares[1]);  // makes the point uniform over the triangle
  const Eigen::Vector3d a = corners[0].cast<double>();
  const Eigen::Vector3d ab = corners[1].cast<double>() - a;
  const Eigen::Vector3d ac = corners[2].cast<double>() - a;
  const Eigen::Vector3d point =
      tracer_.world().origin + a + root * ((1 - shares[2]) * ab + shares[2] * ac);
  Eigen::Vector3d normal = ab.cross(ac).normalized();
  if (mesh.T_world_mesh.linear().determinant() < 0) {
    normal *= -1;
  }
  const double size = bounds().diagonal().norm();
  const double start = 1e-5 * size;  // m, offset from the triangle itself
  const double opposite = distance_along(point + start * normal, normal);
  return point + normal * (start + shares[3] * (opposite > 0 ? opposite : size / 2));
}

Surroundings FreeSpace::look_around(const Eigen::Vector3d& p_world) const {
  const std::vector<ProbeHit> hits =
      probe(tracer_.embree(), tracer_.world(), flat_point(p_world), directions_);
  std::vector<float> distances;
  std::size_t fronts = 0;
  std::size_t level = 0;
  std::size_t level_hits = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const bool is_level = directions_[i].y() < kLevel;
    level += is_level ? 1 : 0;
    if (hits[i].distance > 0) {
      distances.push_back(hits[i].distance);
      fronts += hits[i].front ? 1 : 0;
      level_hits += is_level ? 1 : 0;
    }
  }
  Surroundings result{.hit_share = share(distances.size(), hits.size()),
                      .level_share = share(level_hits, level),
                      .front_share = share(fronts, distances.size())};
  if (!distances.empty()) {
    const auto far = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 3 / 4);
    std::nth_element(distances.begin(), far, distances.end());
    result.far_distance = *far;
  }
  return result;
}

Eigen::Vector3f FreeSpace::flat_point(const Eigen::Vector3d& p_world) const {
  return (p_world - tracer_.world().origin).cast<float>();
}

}  // namespace synth
