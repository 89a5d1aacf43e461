#include "synth/shading/glass.h"

#include <algorithm>
#include <cmath>

#include "synth/shading/layers.h"
#include "synth/shading/scatter.h"

namespace synth {
namespace {

constexpr float kLeastAlpha = 1e-3F;

/// Returns the cosine behind a boundary squared; negative in total internal reflection.
float refracted_cosine2(float cosine, float ratio) {
  return 1 - (1 - cosine * cosine) / (ratio * ratio);
}

/// Returns the share of facets of a GGX surface that is not hidden in a direction at this cosine.
float unmasked(float alpha, float cosine) {
  const float c2 = cosine * cosine;
  return 2 * std::abs(cosine) / (std::abs(cosine) + std::sqrt(alpha * alpha * (1 - c2) + c2));
}

Eigen::Vector3f mirrored(const Eigen::Vector3f& to_viewer, const Eigen::Vector3f& normal) {
  return 2 * to_viewer.dot(normal) * normal - to_viewer;
}

/// Returns the direction behind a thin wall: that of the mirrored ray, on the other side.
Eigen::Vector3f through_wall(const SurfacePoint& point, const Eigen::Vector3f& facet) {
  if (is_clear(point.roughness)) {
    return -point.to_viewer;
  }
  const Eigen::Vector3f back = mirrored(point.to_viewer, facet);
  return back - 2 * back.dot(point.normal) * point.normal;
}

/// Returns how a path goes on at one facet of glass.
GlassScattered scatter_at_facet(const SurfacePoint& point, const Material& material, float choice,
                                const Eigen::Vector3f& facet) {
  const float ratio = index_ratio(point, material);
  const float cosine = std::clamp(facet.dot(point.to_viewer), 0.0F, 1.0F);
  GlassScattered result{Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones()};
  result.is_reflected = choice < glass_reflectance(point, material, cosine, ratio);
  if (result.is_reflected) {
    result.direction = mirrored(point.to_viewer, facet);
    return result;
  }
  result.weight = point.base_color;
  result.direction = material.layers.is_solid
                         ? refracted(point.to_viewer, facet, ratio).value_or(-point.to_viewer)
                         : through_wall(point, facet);
  return result;
}

/// Returns whether a direction is on the side of the triangle to which it belongs.
bool is_on_its_side(const SurfacePoint& point, const GlassScattered& scattered) {
  const float side = point.face_normal.dot(scattered.direction);
  return scattered.is_reflected ? side > 0 : side < 0;
}

GlassScattered scatter_at_rough_glass(const SurfacePoint& point, const Material& material,
                                      float choice, const Eigen::Vector2f& square) {
  const float alpha = point.roughness * point.roughness;
  const Eigen::Vector3f facet = visible_normal(Frame(point.normal), alpha, point.to_viewer, square);
  GlassScattered result = scatter_at_facet(point, material, choice, facet);
  const float cosine = point.normal.dot(result.direction);
  const bool is_possible = is_on_its_side(point, result) && (cosine > 0) == result.is_reflected;
  const float seen = unmasked(alpha, point.normal.dot(point.to_viewer));
  const float lit = unmasked(alpha, cosine);
  // Heights of facets correlate on one side (Smith's masking and shadowing), not on two.
  const float share = result.is_reflected ? lit / (seen + lit - seen * lit) : lit;
  result.weight *= is_possible ? share : 0;
  return result;
}

}  // namespace

float fresnel_reflectance(float cosine, float ratio) {
  const float behind2 = refracted_cosine2(cosine, ratio);
  if (!(behind2 > 0)) {
    return 1;
  }
  const float behind = std::sqrt(behind2);
  const float across = (cosine - ratio * behind) / (cosine + ratio * behind);
  const float along = (ratio * cosine - behind) / (ratio * cosine + behind);
  return 0.5F * (across * across + along * along);
}

float index_ratio(const SurfacePoint& point, const Material& material) {
  const bool leaves = material.layers.is_solid && point.is_from_behind;
  return leaves ? 1 / material.ior : material.ior;
}

float glass_reflectance(const SurfacePoint& point, const Material& material, float cosine,
                        float ratio) {
  if (material.ior == 0) {
    return 1;
  }
  const float whole = fresnel_reflectance(cosine, ratio);
  return whole < 1 ? point.specular * whole : 1;
}

std::optional<Eigen::Vector3f> refracted(const Eigen::Vector3f& to_viewer,
                                         const Eigen::Vector3f& normal, float ratio) {
  const float cosine = normal.dot(to_viewer);
  const float behind2 = refracted_cosine2(cosine, ratio);
  if (!(behind2 > 0)) {
    return std::nullopt;
  }
  const Eigen::Vector3f along = (cosine * normal - to_viewer) / ratio;
  return Eigen::Vector3f((along - std::sqrt(behind2) * normal).normalized());
}

Eigen::Vector3f transmittance(const MaterialLayers& layers, float length) {
  if (std::isinf(layers.attenuation_distance)) {
    return Eigen::Vector3f::Ones();
  }
  const float distances = length / layers.attenuation_distance;
  return layers.attenuation_color.unaryExpr(
      [&](float color) { return std::pow(color, distances); });
}

bool is_clear(float roughness) {
  return roughness * roughness <= kLeastAlpha;
}

bool is_clear_wall(const Material& material) {
  return material.layers.transmission > 0 && !material.layers.is_solid &&
         is_clear(material.roughness) && !material.unlit;
}

Eigen::Vector3f straight_share(const SurfacePoint& point, const Material& material) {
  const float facing = point.normal.dot(point.to_viewer);
  const float cosine =
      std::clamp(facing > 0 ? facing : point.face_normal.dot(point.to_viewer), 0.0F, 1.0F);
  const float glass = point.transmission * (1 - point.metallic);
  const float below_coat =
      1 - coat_reflectance(point.clearcoat, point.coat_normal.dot(point.to_viewer));
  const float reflected = glass_reflectance(point, material, cosine, material.ior);
  return below_coat * glass * (1 - reflected) * point.base_color;
}

GlassScattered scatter_at_glass(const SurfacePoint& point, const Material& material, float choice,
                                const Eigen::Vector2f& square) {
  if (point.normal.dot(point.to_viewer) > 0) {
    if (!is_clear(point.roughness)) {
      return scatter_at_rough_glass(point, material, choice, square);
    }
    GlassScattered result = scatter_at_facet(point, material, choice, point.normal);
    if (is_on_its_side(point, result)) {
      return result;
    }
  }
  return scatter_at_facet(point, material, choice, point.face_normal);
}

}  // namespace synth
