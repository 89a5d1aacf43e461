#pragma once

#include <array>

#include <Eigen/Core>

#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"

namespace synth {

/// Where a ray met the scene.
struct SurfaceHit {
  int mesh = kNone;                                   ///< of WorldGeometry::meshes
  int triangle = kNone;                               ///< of that mesh
  Eigen::Vector3f weights = Eigen::Vector3f::Zero();  ///< of the triangle's vertices, sum 1
};

/// What a ray saw of it. All directions are unit; both normals are on the viewer's side.
struct SurfacePoint {
  Eigen::Vector3f position;     ///< m, in the world-space geometry's coordinates
  Eigen::Vector3f face_normal;  ///< of the triangle
  Eigen::Vector3f normal;       ///< interpolated between the vertices, and of the normal map
  Eigen::Vector3f to_viewer;
  Eigen::Vector3f base_color;  ///< linear RGB
  Eigen::Vector3f emission;    ///< linear RGB
  float alpha = 1;             ///< of the base colour
  float metallic = 0;          ///< 0 to 1
  float roughness = 1;         ///< 0 to 1
  float specular = 0;          ///< Material::specular
  float openness = 1;          ///< share of the ambient light that arrives
  float rounding = 0;          ///< m, how far the position may be off the triangle
  float share = 0;             ///< WorldGeometry::share_at, of when it was seen
};

/// A texture as it lies on one triangle.
struct TexturePatch {
  const Texture* texture = nullptr;     ///< none: the factor alone counts
  const TextureImage* image = nullptr;  ///< of the texture
  std::array<Eigen::Vector2f, 3> uv;    ///< the image's coordinates at the corners
  float lod_at_1m = 0;                  ///< level of detail for a footprint of 1 m

  /// One in all channels where there is no texture. `weights` are of the corners.
  Eigen::Vector4f color(const Eigen::Vector3f& weights, float log2_footprint) const;
};

/// What of a material is asked for.
enum class SurfaceMaps { color, all };

/// What all points of a triangle have in common: neighbouring rays tend to hit the same one.
struct SurfaceTriangle {
  SurfaceTriangle() = default;
  SurfaceTriangle(const WorldGeometry& world, int mesh, int triangle, float share = 0,
                  SurfaceMaps maps = SurfaceMaps::all);

  const FlatMesh* mesh = nullptr;  ///< at the moment before, where it moves
  std::array<int, 3> vertices{};
  std::array<Eigen::Vector3f, 3> corners;  ///< m, in the world-space geometry's coordinates
  std::array<Eigen::Vector3f, 3> normals;  ///< at the corners; of no meaning if the mesh has none
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit, of the front; zero without area
  float rounding = 0;                                ///< m, SurfacePoint's
  TexturePatch base_color;
  TexturePatch metallic_roughness;
  TexturePatch normal_map;
  TexturePatch occlusion;
  TexturePatch emissive;
};

/// A ray that met a triangle.
struct SurfaceRay {
  Eigen::Vector3f weights;    ///< of the triangle's vertices at the hit
  Eigen::Vector3f direction;  ///< of the ray, any length
  float footprint = 0;        ///< m, width of one colour sample's cone at the hit
  float share = 0;            ///< WorldGeometry::share_at, of when the triangle was seen
};

/// The base colour alone, linear RGBA.
Eigen::Vector4f surface_color(const SurfaceTriangle& triangle, const SurfaceRay& ray);

SurfacePoint surface_point(const SurfaceTriangle& triangle, const SurfaceRay& ray);
SurfacePoint surface_point(const WorldGeometry& world, const SurfaceHit& hit,
                           const Eigen::Vector3f& view_direction, float footprint);

/// The base colour's alpha where its texture is sharpest: what is there must not depend on who
/// looks.
float surface_alpha(const WorldGeometry& world, const SurfaceHit& hit);

/// The least alpha that counts as being there, for depth and shadows.
inline float solid_from(const Material& material) {
  return material.alpha_mode == AlphaMode::mask ? material.alpha_cutoff : 0.5F;
}

}  // namespace synth
