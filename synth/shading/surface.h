#pragma once

#include <array>

#include <Eigen/Core>

#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/texture_patch.h"

namespace synth {

/// The point of the scene that a ray hits.
struct SurfaceHit {
  int mesh = kNone;                                   ///< index in WorldGeometry::meshes
  int triangle = kNone;                               ///< index in the mesh's triangles
  Eigen::Vector3f weights = Eigen::Vector3f::Zero();  ///< barycentric, sum 1
};

/// The share of light along the normal that glass of an index of refraction of 1.5 reflects.
inline constexpr float kGlassReflectance = 0.04F;

/// Returns the share of light along the normal that a dielectric of this index of refraction
/// reflects, in air: 1 for 0, which stands for a surface that reflects all.
inline float normal_reflectance(float ior) {
  const double root = (ior - 1.0) / (ior + 1.0);
  return static_cast<float>(root * root);
}

/// A surface point as a ray sees it. All directions are unit; all normals face the viewer.
struct SurfacePoint {
  Eigen::Vector3f position;     ///< m, in the world-space geometry's coordinates
  Eigen::Vector3f face_normal;  ///< normal of the triangle
  Eigen::Vector3f normal;       ///< shading normal: of the vertices and the normal map
  Eigen::Vector3f coat_normal;  ///< of the clear coat: of the vertices and the coat's normal map
  Eigen::Vector3f to_viewer;
  Eigen::Vector3f base_color;  ///< linear RGB
  Eigen::Vector3f emission;    ///< linear RGB
  float alpha = 1;             ///< alpha of the base colour
  float metallic = 0;          ///< 0 to 1
  float roughness = 1;         ///< 0 to 1
  float specular = 0;          ///< 0 to 1, strength of dielectric reflection
  /// What a dielectric reflects of light along the normal, linear RGB, 0 to 1.
  Eigen::Vector3f normal_reflectance = Eigen::Vector3f::Constant(kGlassReflectance);
  float openness = 1;             ///< share of the ambient light that arrives
  float transmission = 0;         ///< 0 to 1, as MaterialLayers::transmission
  float clearcoat = 0;            ///< 0 to 1, strength of the coat
  float clearcoat_roughness = 0;  ///< 0 to 1, of the coat
  float rounding = 0;             ///< m, how far the position may be off the triangle
  float share = 0;                ///< WorldGeometry::share_at of the ray's time
  bool is_from_behind = false;    ///< the viewer is behind the triangle's front
};

/// The maps of a material to prepare: base colour alone, or all.
enum class SurfaceMaps { color, all };

/// The values that all points of a triangle share: neighbouring rays often hit one triangle. Maps
/// that few materials have (those of extensions) are not prepared here, but where they are met.
struct SurfaceTriangle {
  SurfaceTriangle() = default;
  SurfaceTriangle(const WorldGeometry& world, int mesh, int triangle, float share = 0,
                  SurfaceMaps maps = SurfaceMaps::all);

  const FlatMesh* mesh = nullptr;  ///< mesh at the moment before the ray if it moves
  std::array<int, 3> vertices{};
  std::array<Eigen::Vector3f, 3> corners;  ///< m, in the world-space geometry's coordinates
  std::array<Eigen::Vector3f, 3> normals;  ///< at the corners; undefined if the mesh has none
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit, on the front; zero without area
  float double_area = 0;                             ///< m^2
  float rounding = 0;                                ///< m, SurfacePoint::rounding
  const Scene* scene = nullptr;                      ///< scene of the material's textures
  TexturePatch base_color;
  TexturePatch metallic_roughness;
  TexturePatch normal_map;
  TexturePatch occlusion;
  TexturePatch emissive;
};

/// Two sides of the section of a ray's cone across the ray, world axes, in widths of the cone,
/// where it is not round.
using RaySides = std::array<Eigen::Vector3f, 2>;

/// A ray that hits a triangle.
struct SurfaceRay {
  Eigen::Vector3f weights;          ///< barycentric coordinates of the hit
  Eigen::Vector3f direction;        ///< direction of the ray, any length
  float footprint = 0;              ///< m, width of one colour sample's cone at the hit
  float share = 0;                  ///< WorldGeometry::share_at of the ray's time
  int anisotropy = 1;               ///< RenderOptions::anisotropy
  const RaySides* sides = nullptr;  ///< of the cone; null: it is round
};

/// Returns the base colour at a hit, linear RGBA.
Eigen::Vector4f surface_color(const SurfaceTriangle& triangle, const SurfaceRay& ray);

/// Returns the radiance that the surface emits at a hit, linear RGB.
Eigen::Vector3f surface_emission(const SurfaceTriangle& triangle, const SurfaceRay& ray);

/// Returns the strength of the clear coat at a hit, 0 to 1.
float surface_clearcoat(const SurfaceTriangle& triangle, const SurfaceRay& ray);

SurfacePoint surface_point(const SurfaceTriangle& triangle, const SurfaceRay& ray);
SurfacePoint surface_point(const WorldGeometry& world, const SurfaceHit& hit,
                           const Eigen::Vector3f& view_direction, float footprint);

/// Returns the base colour's alpha from the sharpest level of its texture, so that it does not
/// depend on the viewer.
float surface_alpha(const WorldGeometry& world, const SurfaceHit& hit);

/// Returns the least alpha that counts as solid, for depth and shadows.
inline float solid_from(const Material& material) {
  return material.alpha_mode == AlphaMode::mask ? material.alpha_cutoff : 0.5F;
}

}  // namespace synth
