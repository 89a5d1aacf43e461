#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/surface.h"
#include "vo/core/instruction_set.h"

namespace synth {

/// Light from all sides: a surface facing n receives uniform + sky (1 + n . sky_axis) / 2, the
/// second term being what an even sky over half of all directions gives.
struct AmbientLight {
  Eigen::Vector3f uniform = Eigen::Vector3f::Zero();  ///< lx
  Eigen::Vector3f sky = Eigen::Vector3f::Zero();      ///< lx
  Eigen::Vector3f sky_axis = Eigen::Vector3f::UnitY();

  Eigen::Vector3f irradiance(const Eigen::Vector3f& normal) const;

  /// Of the sky that gives this irradiance where nothing hides it.
  Eigen::Vector3f radiance(const Eigen::Vector3f& direction) const;
};

/// `share` is RenderOptions::ambient.
AmbientLight ambient_light(const WorldGeometry& world, double share);

/// What a diffuse surface sends back of light that arrives at it.
inline Eigen::Vector3f lambert(const SurfacePoint& point, const Eigen::Vector3f& irradiance) {
  return point.base_color.cwiseProduct(irradiance) * std::numbers::inv_pi_v<float>;
}

/// What comes back of ambient light. Under light that is the same from all sides a metal sends back
/// its base colour too.
inline Eigen::Vector3f reflect_ambient(const SurfacePoint& point, const AmbientLight& ambient) {
  return point.openness * lambert(point, ambient.irradiance(point.normal));
}

/// A light as it shines on the world-space geometry.
struct PlacedLight {
  LightKind kind = LightKind::point;
  Eigen::Vector3f position = Eigen::Vector3f::Zero();     ///< m, in the world-space geometry's
                                                          ///< coordinates; not of directional ones
  Eigen::Vector3f direction = -Eigen::Vector3f::UnitY();  ///< unit, of travel; not of point lights
  Eigen::Vector3f intensity = Eigen::Vector3f::Ones();  ///< linear RGB; cd, lx of directional ones
  float inverse_range = 0;                              ///< 1/m; 0: it never fades
  float cos_outer = -2;          ///< of the angle off `direction` where a spot light ends
  float inverse_cone_width = 1;  ///< 1 / (cosine where it is full - cos_outer)

  bool has_place() const { return kind != LightKind::directional; }
};

std::vector<PlacedLight> place_lights(const WorldGeometry& world);

/// How one light reaches a point if nothing is between them.
struct DirectLight {
  Eigen::Vector3f to_light;    ///< m to a light that has a place; unit towards a directional one
  Eigen::Vector3f irradiance;  ///< lx on the surface, linear RGB; zero behind the surface
};

/// KHR_lights_punctual: distance, range and cone.
DirectLight direct_light(const PlacedLight& light, const SurfacePoint& point);

/// Of a light that has a place: irradiance per intensity and metre that its direction has along the
/// surface's normal. `along_axis` is how far the light is against its own direction, m.
EDVO_INLINE float fading(const PlacedLight& light, float along_axis, float distance2) {
  const float per_distance = 1 / std::sqrt(distance2);
  const float of_range = distance2 * light.inverse_range * light.inverse_range;
  const float in_range = std::min(1.0F, std::max(0.0F, 1 - of_range * of_range));
  const float inside = (along_axis * per_distance - light.cos_outer) * light.inverse_cone_width;
  const float cone = std::min(1.0F, std::max(0.0F, inside));
  return per_distance * per_distance * per_distance * in_range * (cone * cone);
}

/// What of a surface decides how it reflects, but for its colour.
struct SurfaceFinish {
  float metallic = 0;
  float specular = 0;
  float alpha2 = 1;  ///< GGX's alpha^2
};

/// GGX's, kept off the mirror at 0, in which no light that has no size is seen.
inline float ggx_alpha(const SurfacePoint& point) {
  constexpr float kLeast = 1e-3F;
  return std::max(kLeast, point.roughness * point.roughness);
}

SurfaceFinish finish_of(const SurfacePoint& point);

/// Between normal, light and viewer.
struct LightCosines {
  float n_l;
  float n_v;
  float l_v;
};

/// Radiance per irradiance: tint base_color + gloss.
struct Reflectance {
  float tint;
  float gloss;
};

/// glTF 2.0's metallic-roughness model (its appendix B):
///   (1 - metallic) (1 - F) base / pi + F D V,
/// D and V of GGX with alpha = roughness^2 (V: Smith's, height-correlated, over 4 n.l n.v), F after
/// Schlick from 0.04 specular, or the base colour of a metal. A point with neither metallic nor
/// specular is Lambert's. With h halfway between l and v, v.h = cos(angle(l, v) / 2) and
/// n.h = (n.l + n.v) / (2 v.h).
EDVO_INLINE Reflectance reflectance(const SurfaceFinish& finish, const LightCosines& cosines) {
  constexpr float kInvPi = std::numbers::inv_pi_v<float>;
  constexpr float kDielectric = 0.04F;  // reflected by glass at right angles
  constexpr float kLeastCosine = 1e-4F;
  const float n_l = std::max(kLeastCosine, cosines.n_l);
  const float n_v = std::max(kLeastCosine, cosines.n_v);
  const float v_h = std::sqrt(std::min(1.0F, std::max(0.0F, 0.5F + 0.5F * cosines.l_v)));
  const float halfway = (cosines.n_l + cosines.n_v) * 0.5F / std::max(kLeastCosine, v_h);
  const float n_h = std::min(1.0F, std::max(0.0F, halfway));

  const float alpha2 = finish.alpha2;
  const float spread = n_h * n_h * (alpha2 - 1) + 1;
  const float smith = n_l * std::sqrt(n_v * n_v * (1 - alpha2) + alpha2) +
                      n_v * std::sqrt(n_l * n_l * (1 - alpha2) + alpha2);
  const float lobe = alpha2 * (0.5F * kInvPi) / (spread * spread * smith);
  const float m = 1 - v_h;
  const float grazing = m * m * m * m * m;
  const float glass = finish.specular * (kDielectric + (1 - kDielectric) * grazing);
  const Reflectance dielectric{(1 - glass) * kInvPi, glass * lobe};
  const Reflectance metal{(1 - grazing) * lobe, grazing * lobe};
  return {dielectric.tint + finish.metallic * (metal.tint - dielectric.tint),
          dielectric.gloss + finish.metallic * (metal.gloss - dielectric.gloss)};
}

/// Of a point, linear RGB.
Eigen::Vector3f reflectance(const SurfacePoint& point, const Eigen::Vector3f& to_light);

}  // namespace synth
