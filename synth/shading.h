#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/flat_scene.h"
#include "synth/scene.h"
#include "synth/surface.h"

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
AmbientLight ambient_light(const FlatScene& flat, double share);

/// What a diffuse surface sends back of light that arrives at it.
inline Eigen::Vector3f lambert(const SurfacePoint& point, const Eigen::Vector3f& irradiance) {
  return point.base_color.cwiseProduct(irradiance) * std::numbers::inv_pi_v<float>;
}

/// What comes back of ambient light. Under light that is the same from all sides a metal sends back
/// its base colour too.
inline Eigen::Vector3f reflect_ambient(const SurfacePoint& point, const AmbientLight& ambient) {
  return point.openness * lambert(point, ambient.irradiance(point.normal));
}

/// A light as it shines on the flat scene.
struct PlacedLight {
  LightKind kind = LightKind::point;
  Eigen::Vector3f position;      ///< m, in the flat scene's coordinates; not of directional ones
  Eigen::Vector3f direction;     ///< unit, of travel; not of point lights
  Eigen::Vector3f intensity;     ///< linear RGB; cd, lx of directional ones
  float inverse_range = 0;       ///< 1/m; 0: it never fades
  float cos_outer = -1;          ///< of the angle off `direction` where a spot light ends
  float inverse_cone_width = 0;  ///< 1 / (cosine where it is full - cos_outer)

  bool has_place() const { return kind != LightKind::directional; }
};

std::vector<PlacedLight> place_lights(const FlatScene& flat);

/// How one light reaches a point if nothing is between them.
struct DirectLight {
  Eigen::Vector3f to_light;    ///< m to a light that has a place; unit towards a directional one
  Eigen::Vector3f irradiance;  ///< lx on the surface, linear RGB; zero behind the surface
};

/// KHR_lights_punctual: distance, range and cone.
DirectLight direct_light(const PlacedLight& light, const SurfacePoint& point);

/// glTF 2.0's metallic-roughness model (its appendix B), radiance per irradiance of a light:
///   (1 - metallic) (1 - F) base / pi + F D V,
/// D and V of GGX with alpha = roughness^2 (V: Smith's, height-correlated, over 4 n.l n.v), F after
/// Schlick from 0.04 specular, or the base colour of a metal. A point with neither metallic nor
/// specular is Lambert's.
Eigen::Vector3f reflectance(const SurfacePoint& point, const Eigen::Vector3f& to_light);

/// GGX's, kept off the mirror at 0, in which no light that has no size is seen.
inline float ggx_alpha(const SurfacePoint& point) {
  constexpr float kLeast = 1e-3F;
  return std::max(kLeast, point.roughness * point.roughness);
}

/// What comes back of one light.
inline Eigen::Vector3f reflect_light(const SurfacePoint& point, const DirectLight& direct) {
  if (point.specular == 0 && point.metallic == 0) {
    return lambert(point, direct.irradiance);
  }
  return reflectance(point, direct.to_light).cwiseProduct(direct.irradiance);
}

}  // namespace synth
