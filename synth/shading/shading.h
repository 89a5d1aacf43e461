#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/environment_light.h"
#include "synth/shading/surface.h"
#include "vo/core/instruction_set.h"

namespace synth {

/// Ambient light: a surface facing n receives the irradiance uniform + sky (1 + n . sky_axis) / 2,
/// the second term being that of a uniform sky over one hemisphere, or that of an environment.
struct AmbientLight {
  Eigen::Vector3f uniform = Eigen::Vector3f::Zero();  ///< lx, from all directions, linear RGB
  Eigen::Vector3f sky = Eigen::Vector3f::Zero();      ///< lx, facing the sky, linear RGB
  Eigen::Vector3f sky_axis = Eigen::Vector3f::UnitY();
  std::optional<EnvironmentIrradiance> environment;  ///< in place of the two others

  Eigen::Vector3f irradiance(const Eigen::Vector3f& normal) const;

  /// Returns the radiance from a direction that causes `irradiance` where nothing occludes it;
  /// requires that there is no environment, whose EnvironmentLight returns it.
  Eigen::Vector3f radiance(const Eigen::Vector3f& direction) const;
};

/// Returns the scene's ambient light: of its environment, if it has one, otherwise as RenderOptions
/// says, whose `ambient` is `share`.
AmbientLight ambient_light(const WorldGeometry& world, double share);

/// Returns the radiance that a diffuse surface reflects of an irradiance.
inline Eigen::Vector3f lambert(const SurfacePoint& point, const Eigen::Vector3f& irradiance) {
  return point.base_color.cwiseProduct(irradiance) * std::numbers::inv_pi_v<float>;
}

/// Returns the reflected radiance of ambient light. A metal reflects its base colour too, since the
/// light is taken as uniform over all directions.
inline Eigen::Vector3f reflect_ambient(const SurfacePoint& point, const AmbientLight& ambient) {
  return point.openness * lambert(point, ambient.irradiance(point.normal));
}

/// A light source in the coordinates of the world-space geometry.
struct PlacedLight {
  LightKind kind = LightKind::point;
  Eigen::Vector3f position = Eigen::Vector3f::Zero();     ///< m; unused for directional lights
  Eigen::Vector3f direction = -Eigen::Vector3f::UnitY();  ///< unit, of travel; no effect if point
  Eigen::Vector3f intensity = Eigen::Vector3f::Ones();    ///< linear RGB, cd; directional: lx
  float inverse_range = 0;                                ///< 1/m; 0 = unlimited range
  float cos_outer = -2;          ///< cosine of a spot light's outer cone angle
  float inverse_cone_width = 1;  ///< 1 / (cosine of the inner cone angle - cos_outer)

  bool has_place() const { return kind != LightKind::directional; }
};

std::vector<PlacedLight> place_lights(const WorldGeometry& world);

/// The light of one source at a surface point without occluders.
struct DirectLight {
  Eigen::Vector3f to_light;    ///< m to a light with a position; unit towards a directional one
  Eigen::Vector3f irradiance;  ///< lx on the surface, linear RGB; zero behind the surface
};

/// Returns the unoccluded light, with distance, range and cone as in KHR_lights_punctual.
DirectLight direct_light(const PlacedLight& light, const SurfacePoint& point);

/// Returns the irradiance per intensity of a light with a position, divided by the extent, m, of
/// the vector to the light along the surface normal. `along_axis` is that vector's extent against
/// the light's own direction, m, and `distance2` its squared length, m^2.
EDVO_INLINE float fading(const PlacedLight& light, float along_axis, float distance2) {
  const float per_distance = 1 / std::sqrt(distance2);
  const float of_range = distance2 * light.inverse_range * light.inverse_range;
  const float in_range = std::min(1.0F, std::max(0.0F, 1 - of_range * of_range));
  const float inside = (along_axis * per_distance - light.cos_outer) * light.inverse_cone_width;
  const float cone = std::min(1.0F, std::max(0.0F, inside));
  return per_distance * per_distance * per_distance * in_range * (cone * cone);
}

/// The BRDF parameters of a surface other than its colour.
struct SurfaceFinish {
  float metallic = 0;
  float specular = 0;
  float alpha2 = 1;  ///< GGX's alpha^2
  /// Of a dielectric, red, green, blue.
  std::array<float, 3> normal_reflectance{kGlassReflectance, kGlassReflectance, kGlassReflectance};
};

/// Returns GGX's alpha, at least 0.001: in a perfect mirror a light without a size is invisible.
inline float ggx_alpha(const SurfacePoint& point) {
  constexpr float kLeast = 1e-3F;
  return std::max(kLeast, point.roughness * point.roughness);
}

SurfaceFinish finish_of(const SurfacePoint& point);

/// The cosines between normal (n), direction to the light (l) and to the viewer (v), and h halfway
/// between these two. That of n and h follows from the others, but not in single precision where l
/// and v are nearly opposite, at grazing angles: on smooth surfaces D would be wrong by its own
/// size.
struct LightCosines {
  float n_l;
  float n_v;
  float l_v;
  float n_h;
};

/// A BRDF's value, radiance per irradiance: tint base_color + gloss.
struct Reflectance {
  float tint;
  std::array<float, 3> gloss;  ///< red, green, blue
};

/// Returns the BRDF of glTF 2.0's metallic-roughness model (its appendix B):
///   (1 - metallic) (1 - max F) base / pi + F D V,
/// D and V of GGX with alpha = roughness^2 (V: Smith's, height-correlated, over 4 n.l n.v), F after
/// Schlick from the normal reflectance and times specular, or from the base colour of a metal; max
/// F is the greatest of its colours (KHR_materials_specular). A point with neither metallic nor
/// specular is Lambertian. With h halfway between l and v, v.h = cos(angle(l, v) / 2).
EDVO_INLINE Reflectance reflectance(const SurfaceFinish& finish, const LightCosines& cosines) {
  constexpr float kInvPi = std::numbers::inv_pi_v<float>;
  constexpr float kLeastCosine = 1e-4F;
  const float n_l = std::max(kLeastCosine, cosines.n_l);
  const float n_v = std::max(kLeastCosine, cosines.n_v);
  const float v_h = std::sqrt(std::min(1.0F, std::max(0.0F, 0.5F + 0.5F * cosines.l_v)));
  const float n_h = std::min(1.0F, std::max(0.0F, cosines.n_h));

  const float alpha2 = finish.alpha2;
  const float spread = n_h * n_h * (alpha2 - 1) + 1;
  const float smith = n_l * std::sqrt(n_v * n_v * (1 - alpha2) + alpha2) +
                      n_v * std::sqrt(n_l * n_l * (1 - alpha2) + alpha2);
  const float lobe = alpha2 * (0.5F * kInvPi) / (spread * spread * smith);
  const float m = 1 - v_h;
  const float grazing = m * m * m * m * m;
  std::array<float, 3> glass;
  for (std::size_t i = 0; i < 3; ++i) {
    const float straight = finish.normal_reflectance[i];
    glass[i] = finish.specular * (straight + (1 - straight) * grazing);
  }
  const float matt = (1 - std::max(glass[0], std::max(glass[1], glass[2]))) * kInvPi;
  const float metal_tint = (1 - grazing) * lobe;
  const float metal_gloss = grazing * lobe;
  Reflectance reflected{matt + finish.metallic * (metal_tint - matt), {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const float gloss = glass[i] * lobe;
    reflected.gloss[i] = gloss + finish.metallic * (metal_gloss - gloss);
  }
  return reflected;
}

/// Returns the BRDF of a point towards its viewer, linear RGB; `to_light` may have any length.
Eigen::Vector3f reflectance(const SurfacePoint& point, const Eigen::Vector3f& to_light);

}  // namespace synth
