#include "synth/shading/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace synth {
namespace {

/// Returns the share of a point light's flux that meets the box, which for a light outside is taken
/// as a sphere of equal surface about the box's centre.
double share_received(const Eigen::AlignedBox3d& box, double surface,
                      const Eigen::Vector3d& position) {
  if (box.contains(position)) {
    return 1;
  }
  const double radius2 = surface / (4 * std::numbers::pi);
  const double distance2 = (position - box.center()).squaredNorm();
  return (1 - std::sqrt(1 - std::min(1.0, radius2 / distance2))) / 2;
}

/// Returns the solid angle into which a light with a position shines, sr; of a spot light, the mean
/// of its inner and its outer cone.
double solid_angle(const Light& light) {
  constexpr double pi = std::numbers::pi;
  return light.kind == LightKind::spot
             ? pi * (2 - std::cos(light.inner_cone) - std::cos(light.outer_cone))
             : 4 * pi;
}

/// Returns the irradiance, lx, if the flux that enters the box spread evenly over its surface.
Eigen::Vector3d mean_irradiance(const std::vector<Light>& lights, const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d size = box.sizes();
  const double surface = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Light& light : lights) {
    const Eigen::Vector3d intensity = light.intensity.cast<double>();
    if (light.kind == LightKind::directional) {
      sum += intensity / 4;  // a convex body's shadow is a quarter of its surface on average
    } else if (surface > 0) {
      sum +=
          intensity * (solid_angle(light) * share_received(box, surface, light.position)) / surface;
    }
  }
  return sum;
}

/// Returns the sky of scenes without lights, whose brightest surfaces show their base colour.
AmbientLight default_sky(double share) {
  const double sky = std::numbers::pi / (1 + share / 2);
  AmbientLight light;
  light.uniform.setConstant(static_cast<float>(sky * share / 2));
  light.sky.setConstant(static_cast<float>(sky));
  light.sky_axis = Eigen::Vector3f(0.3F, 1.0F, 0.5F).normalized();
  return light;
}

}  // namespace

Eigen::Vector3f AmbientLight::irradiance(const Eigen::Vector3f& normal) const {
  if (environment) {
    return (*environment)(normal);
  }
  return uniform + sky * (0.5F + 0.5F * normal.dot(sky_axis));
}

Eigen::Vector3f AmbientLight::radiance(const Eigen::Vector3f& direction) const {
  const float above = direction.dot(sky_axis) > 0 ? 1.0F : 0.0F;
  return (uniform + above * sky) * std::numbers::inv_pi_v<float>;
}

AmbientLight ambient_light(const WorldGeometry& world, double share) {
  if (!world.scene->environment.empty()) {
    AmbientLight light;
    light.environment.emplace(world.scene->environment);
    return light;
  }
  if (world.scene->lights.empty()) {
    return default_sky(share);
  }
  const Eigen::AlignedBox3d box = lit_bounds(world);
  AmbientLight light;
  if (!box.isEmpty()) {
    light.uniform = (share * mean_irradiance(world.scene->lights, box)).cast<float>();
  }
  return light;
}

std::vector<PlacedLight> place_lights(const WorldGeometry& world) {
  constexpr double kLeastConeWidth = 1e-3;  // limit of KHR_lights_punctual
  std::vector<PlacedLight> placed;
  for (const Light& light : world.scene->lights) {
    PlacedLight& added = placed.emplace_back();
    added.kind = light.kind;
    added.position = (light.position - world.origin).cast<float>();
    added.direction = light.direction.cast<float>();
    added.intensity = light.intensity;
    added.inverse_range = static_cast<float>(1 / light.range);
    if (light.kind == LightKind::spot) {
      const double cos_outer = std::cos(light.outer_cone);
      const double cone_width = std::cos(light.inner_cone) - cos_outer;
      added.cos_outer = static_cast<float>(cos_outer);
      added.inverse_cone_width = static_cast<float>(1 / std::max(kLeastConeWidth, cone_width));
    }
  }
  return placed;
}

DirectLight direct_light(const PlacedLight& light, const SurfacePoint& point) {
  const Eigen::Vector3f to_light =
      light.has_place() ? Eigen::Vector3f(light.position - point.position) : -light.direction;
  const float along_normal = to_light.dot(point.normal);
  if (!(along_normal > 0) || to_light.dot(point.face_normal) <= 0) {
    return {to_light, Eigen::Vector3f::Zero()};
  }
  if (!light.has_place()) {
    return {to_light, light.intensity * along_normal};
  }
  const float along_axis = -light.direction.dot(to_light);
  return {to_light,
          light.intensity * (along_normal * fading(light, along_axis, to_light.squaredNorm()))};
}

SurfaceFinish finish_of(const SurfacePoint& point) {
  const float alpha = ggx_alpha(point);
  const Eigen::Vector3f& straight = point.normal_reflectance;
  return {
      point.metallic, point.specular, alpha * alpha, {straight.x(), straight.y(), straight.z()}};
}

Eigen::Vector3f reflectance(const SurfacePoint& point, const Eigen::Vector3f& to_light) {
  const Eigen::Vector3f l = to_light.normalized();
  const Reflectance reflected =
      reflectance(finish_of(point), {.n_l = point.normal.dot(l),
                                     .n_v = point.normal.dot(point.to_viewer),
                                     .l_v = l.dot(point.to_viewer),
                                     .n_h = point.normal.dot((l + point.to_viewer).normalized())});
  return point.base_color * reflected.tint + Eigen::Vector3f(reflected.gloss.data());
}

}  // namespace synth
