#include "synth/shading/emitters.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "synth/shading/layers.h"
#include "synth/shading/spherical_triangle.h"

namespace synth {
namespace {

/// Returns the area of a triangle, m^2.
float area_of(const std::array<Eigen::Vector3f, 3>& corners) {
  return 0.5F * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
}

/// Returns barycentric coordinates that are uniform over a triangle if `square` is over its own.
Eigen::Vector3f even_weights(const Eigen::Vector2f& square) {
  const float root = std::sqrt(square.x());
  return {1 - root, root * (1 - square.y()), root * square.y()};
}

/// Returns how strongly a triangle shines, about: the emission of its middle, blurred over the
/// triangle, and a tenth of the material's, since other parts may shine where the middle is dark.
float strength_of(const SurfaceTriangle& triangle) {
  const float width = std::sqrt(area_of(triangle.corners));
  if (!(width > 0)) {
    return 0;
  }
  constexpr float kRest = 0.1F;
  const Eigen::Vector3f middle =
      surface_emission(triangle, {Eigen::Vector3f::Constant(1.0F / 3), triangle.normal, width});
  return middle.maxCoeff() + kRest * triangle.mesh->material->emission.maxCoeff();
}

/// Returns the share of a surface that shines at a point: 1, or as its alpha says.
float shining_share(const WorldGeometry& world, const Material& material, const SurfaceHit& hit) {
  if (material.alpha_mode == AlphaMode::opaque) {
    return 1;
  }
  const float alpha = surface_alpha(world, hit);
  if (material.alpha_mode == AlphaMode::mask) {
    return alpha < material.alpha_cutoff ? 0.0F : 1.0F;
  }
  return std::clamp(alpha, 0.0F, 1.0F);
}

/// Returns what a triangle covers of the directions about a point that is near it, as measured by
/// its longest edge: directions to it are drawn evenly. Returns none for a far one, on which
/// places are drawn evenly, and for one whose plane the point is in.
std::optional<SphericalTriangle> seen_nearby(const Eigen::Vector3f& point,
                                             const SurfaceTriangle& triangle) {
  constexpr float kNear = 2;       // lengths of the longest edge
  constexpr float kLeast = 1e-4F;  // sr
  constexpr float kMost = 6.2F;    // sr
  const Eigen::Vector3f a = triangle.corners[0] - point;
  const Eigen::Vector3f b = triangle.corners[1] - point;
  const Eigen::Vector3f c = triangle.corners[2] - point;
  const float longest2 =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if ((a + b + c).squaredNorm() > 9 * kNear * kNear * longest2) {
    return std::nullopt;
  }
  const SphericalTriangle seen({a, b, c});
  const bool is_open = seen.solid_angle() > kLeast && seen.solid_angle() < kMost;
  return is_open ? std::optional(seen) : std::nullopt;
}

/// Returns barycentric coordinates of the point where a line from a point meets a triangle.
Eigen::Vector3f weights_along(const Eigen::Vector3f& from, const Eigen::Vector3f& direction,
                              const std::array<Eigen::Vector3f, 3>& corners) {
  const Eigen::Vector3f a = corners[1] - corners[0];
  const Eigen::Vector3f b = corners[2] - corners[0];
  const Eigen::Vector3f start = from - corners[0];
  const Eigen::Vector3f p = direction.cross(b);
  const Eigen::Vector3f q = start.cross(a);
  const float determinant = a.dot(p);
  const float u = std::clamp(start.dot(p) / determinant, 0.0F, 1.0F);
  const float v = std::clamp(direction.dot(q) / determinant, 0.0F, 1 - u);
  return {1 - u - v, u, v};
}

/// Returns the density, 1/sr, of directions that are drawn towards a triangle, `cosine` being that
/// of its normal and the direction; zero for a triangle that is seen from its edge.
float density_towards(const std::optional<SphericalTriangle>& near, float area, float distance,
                      float cosine) {
  constexpr float kLeastCosine = 1e-6F;
  if (!(cosine > kLeastCosine && area > 0)) {
    return 0;
  }
  return near ? 1 / near->solid_angle() : distance * distance / (area * cosine);
}

}  // namespace

Emitters::Emitters(const WorldGeometry& world) : world_(world), first_(world.meshes.size(), -1) {
  for (std::size_t i = 0; i < world.meshes.size(); ++i) {
    const Material& material = *world.meshes[i].material;
    if (!material.unlit && material.emission.maxCoeff() > 0) {
      add_mesh(static_cast<int>(i));
    }
  }
  const double sum = triangles_.empty() ? 0 : triangles_.back().cumulative;
  if (!(sum > 0)) {
    triangles_.clear();
    return;
  }
  for (Triangle& triangle : triangles_) {
    triangle.probability = static_cast<float>(triangle.probability / sum);
    triangle.cumulative /= sum;
  }
  constexpr std::size_t kMostPrepared = 4096;
  if (triangles_.size() <= kMostPrepared) {
    for (const Triangle& triangle : triangles_) {
      prepared_.emplace_back(world, triangle.mesh, triangle.index);
    }
  }
}

/// Adds a mesh's triangles, for now with the power that each shines with as its probability.
void Emitters::add_mesh(int mesh) {
  const auto index = static_cast<std::size_t>(mesh);
  first_[index] = static_cast<std::ptrdiff_t>(triangles_.size());
  const auto count = static_cast<int>(world_.meshes[index].mesh->triangles.size());
  for (int i = 0; i < count; ++i) {
    const SurfaceTriangle triangle(world_, mesh, i);
    const float power = area_of(triangle.corners) * strength_of(triangle);
    const double before = triangles_.empty() ? 0 : triangles_.back().cumulative;
    triangles_.push_back({mesh, i, power, before + power});
  }
}

DrawnLight Emitters::draw(const EmitterDraw& draw) const {
  const auto chosen = std::upper_bound(
      triangles_.begin(), triangles_.end() - 1, static_cast<double>(draw.choice),
      [](double choice, const Triangle& triangle) { return choice < triangle.cumulative; });
  const auto index = static_cast<std::size_t>(chosen - triangles_.begin());
  const bool is_prepared =
      !prepared_.empty() && world_.meshes[static_cast<std::size_t>(chosen->mesh)].moments.empty();
  return is_prepared
             ? draw_towards(prepared_[index], *chosen, draw)
             : draw_towards(SurfaceTriangle(world_, chosen->mesh, chosen->index, draw.share),
                            *chosen, draw);
}

DrawnLight Emitters::draw_towards(const SurfaceTriangle& triangle, const Triangle& chosen,
                                  const EmitterDraw& draw) const {
  const std::optional<SphericalTriangle> near = seen_nearby(draw.from, triangle);
  const Eigen::Vector3f weights =
      near ? weights_along(draw.from, near->direction(draw.square), triangle.corners)
           : even_weights(draw.square);
  const Eigen::Vector3f place = triangle.corners[0] * weights[0] +
                                triangle.corners[1] * weights[1] + triangle.corners[2] * weights[2];
  const Eigen::Vector3f line = place - draw.from;
  const float distance = line.norm();
  const float slant = triangle.normal.dot(line) / distance;
  DrawnLight light;
  light.density = chosen.probability *
                  density_towards(near, area_of(triangle.corners), distance, std::abs(slant));
  if (light.density > 0) {
    const Eigen::Vector3f facing = slant > 0 ? Eigen::Vector3f(-triangle.normal) : triangle.normal;
    light.to_light = line + triangle.rounding * facing;
    const SurfaceRay ray{weights, line, draw.sample_width * (draw.travelled + distance)};
    light.radiance =
        shining_share(world_, *triangle.mesh->material, {chosen.mesh, chosen.index, weights}) *
        (1 - coat_reflectance(surface_clearcoat(triangle, ray), std::abs(slant))) *
        surface_emission(triangle, ray);
  }
  return light;
}

float Emitters::density(const SurfaceTriangle& triangle, std::size_t mesh, int index,
                        const SurfacePoint& point, float distance) const {
  if (first_[mesh] < 0 || triangles_.empty()) {
    return 0;
  }
  const Triangle& drawn = triangles_[static_cast<std::size_t>(first_[mesh] + index)];
  const std::optional<SphericalTriangle> near =
      seen_nearby(point.position + distance * point.to_viewer, triangle);
  return drawn.probability * density_towards(near, area_of(triangle.corners), distance,
                                             std::abs(point.face_normal.dot(point.to_viewer)));
}

}  // namespace synth
