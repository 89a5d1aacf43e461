#pragma once

#include <numbers>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/flat_scene.h"
#include "synth/scene.h"

namespace synth {

/// Where a ray met the scene.
struct SurfaceHit {
  int mesh = kNone;                                   ///< of FlatScene::meshes
  int triangle = kNone;                               ///< of that mesh
  Eigen::Vector3f weights = Eigen::Vector3f::Zero();  ///< of the triangle's vertices, sum 1
};

/// What a ray saw of it. Both normals are unit and on the viewer's side.
struct SurfacePoint {
  Eigen::Vector3f position;     ///< m, in the flat scene's coordinates
  Eigen::Vector3f face_normal;  ///< of the triangle
  Eigen::Vector3f normal;       ///< interpolated between the vertices
  Eigen::Vector3f base_color;   ///< linear RGB
  Eigen::Vector3f emission;     ///< linear RGB
  float rounding = 0;           ///< m, how far the position may be off the triangle
};

/// `view_direction` is the ray's, of any length; `footprint` is the width of one colour sample's
/// cone at the hit, m.
SurfacePoint surface_point(const FlatScene& flat, const SurfaceHit& hit,
                           const Eigen::Vector3f& view_direction, float footprint);

/// Light from all sides: a surface facing n receives uniform + sky (1 + n . sky_axis) / 2, the
/// second term being what an even sky over half of all directions gives.
struct AmbientLight {
  Eigen::Vector3f uniform = Eigen::Vector3f::Zero();  ///< lx
  Eigen::Vector3f sky = Eigen::Vector3f::Zero();      ///< lx
  Eigen::Vector3f sky_axis = Eigen::Vector3f::UnitY();

  Eigen::Vector3f irradiance(const Eigen::Vector3f& normal) const;
};

/// `share` is RenderOptions::ambient.
AmbientLight ambient_light(const FlatScene& flat, double share);

/// What a diffuse surface sends back of light that arrives at it.
inline Eigen::Vector3f lambert(const SurfacePoint& point, const Eigen::Vector3f& irradiance) {
  return point.base_color.cwiseProduct(irradiance) * std::numbers::inv_pi_v<float>;
}

/// How one light reaches a point if nothing is between them.
struct DirectLight {
  Eigen::Vector3f to_light;    ///< m to a point light; unit towards a directional one
  Eigen::Vector3f irradiance;  ///< lx on the surface, linear RGB; zero behind the surface
};

/// `position` is the light's in the flat scene's coordinates.
DirectLight direct_light(const Light& light, const Eigen::Vector3f& position,
                         const SurfacePoint& point);

}  // namespace synth
