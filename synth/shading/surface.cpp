#include "synth/shading/surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "synth/scene/texture.h"

namespace synth {
namespace {

/// The least cosine of a slant at which textures are still blurred further.
constexpr float kMinCosine = 0.05F;

template <typename Values>
auto interpolate(const Values& values, const std::array<int, 3>& triangle,
                 const Eigen::Vector3f& weights) {
  return (values[triangle[0]] * weights[0] + values[triangle[1]] * weights[1] +
          values[triangle[2]] * weights[2])
      .eval();
}

constexpr std::array<int, 3> kCorners{0, 1, 2};

/// Returns the patch of a map that few materials have; without a texture where there is no map.
TexturePatch extension_patch(const SurfaceTriangle& triangle, const TextureSlot& slot) {
  return slot.texture == kNone ? TexturePatch()
                               : texture_patch(*triangle.scene, *triangle.mesh, slot,
                                               triangle.vertices, triangle.double_area);
}

/// Returns the value of a map of an extension at a hit, linear RGBA; ones without a texture.
Eigen::Vector4f extension_texel(const SurfaceTriangle& triangle, const TextureSlot& slot,
                                const SampleFootprint& footprint) {
  const TexturePatch patch = extension_patch(triangle, slot);
  return patch.texture == nullptr ? Eigen::Vector4f::Ones().eval() : patch.color(footprint);
}

Eigen::Vector3f normal_between(const MomentPair& moments, int vertex) {
  Eigen::Vector3f normal = moments.before->normal(vertex);
  if (moments.share != 0) {
    normal += moments.share * (moments.after->normal(vertex) - normal);
  }
  return normal;
}

/// Returns the greatest coordinate that takes part in finding a hit, m.
float extent_of(const WorldGeometry& world, const SurfaceTriangle& triangle) {
  const std::array<Eigen::Vector3f, 3>& corners = triangle.corners;
  const Eigen::Array3f extent =
      corners[0].array().abs().max(corners[1].array().abs()).max(corners[2].array().abs());
  const FlatMesh& mesh = *triangle.mesh;
  if (mesh.shared == kNone) {
    return extent.maxCoeff();
  }
  const Eigen::Vector3d place = T_flat_shared(world, mesh).translation();
  return extent.maxCoeff() + place.cast<float>().cwiseAbs().maxCoeff();
}

/// Returns the interpolated unit normal, or the triangle's where there is none.
Eigen::Vector3f vertex_normal(const SurfaceTriangle& triangle, const Eigen::Vector3f& weights) {
  if (!triangle.mesh->has_normals()) {
    return triangle.normal;
  }
  constexpr float kMinLength = 1e-3F;  // shorter: opposite normals that cancel out
  const Eigen::Vector3f normal = interpolate(triangle.normals, kCorners, weights);
  const float length = normal.norm();
  return length > kMinLength ? Eigen::Vector3f(normal / length) : triangle.normal;
}

/// Returns the tangent, along which u grows, and in w the bitangent's side: of the mesh or, without
/// tangents of its own, of a normal map's coordinates.
Eigen::Vector4f tangent_of(const SurfaceTriangle& triangle, const TexturePatch& map,
                           const Eigen::Vector3f& weights) {
  const FlatMesh& world = *triangle.mesh;
  if (!world.mesh->tangents.empty()) {
    const Eigen::Vector4f tangent = interpolate(world.mesh->tangents, triangle.vertices, weights);
    Eigen::Vector4f placed;
    placed << world.T_world_mesh.linear().cast<float>() * tangent.head<3>(),
        world.T_world_mesh.linear().determinant() < 0 ? -tangent.w() : tangent.w();
    return placed;
  }
  const Eigen::Vector3f a = triangle.corners[1] - triangle.corners[0];
  const Eigen::Vector3f b = triangle.corners[2] - triangle.corners[0];
  const Eigen::Vector2f uv_a = map.uv[1] - map.uv[0];
  const Eigen::Vector2f uv_b = map.uv[2] - map.uv[0];
  const float determinant = uv_a.x() * uv_b.y() - uv_a.y() * uv_b.x();
  const Eigen::Vector3f along_u = (a * uv_b.y() - b * uv_a.y()) * (determinant < 0 ? -1.0F : 1.0F);
  const Eigen::Vector3f along_v = (b * uv_a.x() - a * uv_b.x()) * (determinant < 0 ? -1.0F : 1.0F);
  Eigen::Vector4f tangent;
  // glTF's bitangent points up in the image, where v falls.
  tangent << along_u, triangle.normal.cross(along_u).dot(-along_v) < 0 ? -1.0F : 1.0F;
  return tangent;
}

/// A normal map on a triangle and the factor of its x and y.
struct NormalMap {
  const TexturePatch& patch;
  float scale;
};

/// Returns the unit normal of glTF's normal map in the tangent frame about `normal`.
Eigen::Vector3f mapped_normal(const SurfaceTriangle& triangle, const NormalMap& map,
                              const SampleFootprint& footprint, const Eigen::Vector3f& normal) {
  const Eigen::Vector4f tangent = tangent_of(triangle, map.patch, footprint.weights);
  const Eigen::Vector3f across =
      tangent.head<3>() - normal * normal.dot(tangent.head<3>());  // Gram-Schmidt
  const float length = across.norm();
  if (!(length > std::numeric_limits<float>::min())) {
    return normal;
  }
  const Eigen::Vector3f t = across / length;
  const Eigen::Vector3f b = tangent.w() * normal.cross(t);
  const Eigen::Vector3f texel = 2 * map.patch.color(footprint).head<3>() - Eigen::Vector3f::Ones();
  const Eigen::Vector3f mapped =
      t * (map.scale * texel.x()) + b * (map.scale * texel.y()) + normal * texel.z();
  const float mapped_length = mapped.norm();
  return mapped_length > 0 ? Eigen::Vector3f(mapped / mapped_length) : normal;
}

Eigen::Vector4f color_of(const SurfaceTriangle& triangle, const SampleFootprint& footprint) {
  Eigen::Vector4f color = triangle.mesh->material->base_color;
  if (triangle.base_color.texture != nullptr) {
    color.array() *= triangle.base_color.color(footprint).array();
  }
  const std::vector<Eigen::Vector4f>& colors = triangle.mesh->mesh->colors;
  if (!colors.empty()) {
    color.array() *= interpolate(colors, triangle.vertices, footprint.weights).array();
  }
  return color;
}

/// Returns the binary logarithm of a positive number to 1e-3, enough for a level of detail: the
/// exponent plus a fit to log2(1 + f) that is exact at 0 and 1.
float quick_log2(float value) {
  constexpr int kMantissaBits = 23;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const auto exponent = static_cast<float>(static_cast<int>(bits >> kMantissaBits) - 127);
  const float f = std::bit_cast<float>((bits & 0x7fffffU) | 0x3f800000U) - 1;
  return exponent + f + f * (1 - f) * (0.43807F - f * (0.23669F - f * 0.08031F));
}

/// Returns the cosine between ray and triangle normal.
float slant_cosine(const SurfaceTriangle& triangle, const SurfaceRay& ray) {
  return std::abs(triangle.normal.dot(ray.direction)) / ray.direction.norm();
}

/// Returns how barycentric coordinates change along a vector in the triangle's plane, m.
Eigen::Vector3f weights_along(const SurfaceTriangle& triangle, const Eigen::Vector3f& vector) {
  const Eigen::Vector3f a = triangle.corners[1] - triangle.corners[0];
  const Eigen::Vector3f b = triangle.corners[2] - triangle.corners[0];
  const Eigen::Vector3f cross = a.cross(b) / a.cross(b).squaredNorm();
  const float along_a = vector.cross(b).dot(cross);
  const float along_b = a.cross(vector).dot(cross);
  return {-along_a - along_b, along_a, along_b};
}

/// Returns where a vector across a unit direction ends on the triangle's plane, along that
/// direction and from where it begins.
Eigen::Vector3f cast_along(const Eigen::Vector3f& direction, const Eigen::Vector3f& normal,
                           const Eigen::Vector3f& vector) {
  const float slant = normal.dot(direction);
  const float limited = std::copysign(std::max(kMinCosine, std::abs(slant)), slant);
  return vector - direction * (normal.dot(vector) / limited);
}

/// Returns the section of a ray's cone with the triangle: as long across the slant as the cone is
/// wide, and along it over the cosine more. Without a texture to read there it has no size.
SampleFootprint footprint_of(const SurfaceTriangle& triangle, const SurfaceRay& ray, float cosine) {
  if (!triangle.mesh->is_textured) {
    return {ray.weights};
  }
  const float limited = std::max(kMinCosine, cosine);
  SampleFootprint footprint{ray.weights, quick_log2(ray.footprint / limited)};
  if (ray.anisotropy == 1 || triangle.double_area == 0) {
    return footprint;
  }
  footprint.anisotropy = ray.anisotropy;
  const Eigen::Vector3f direction = ray.direction.normalized();
  if (ray.sides != nullptr) {
    for (std::size_t i = 0; i < 2; ++i) {
      footprint.diameters[i] = weights_along(
          triangle, cast_along(direction, triangle.normal, ray.footprint * (*ray.sides)[i]));
    }
    return footprint;
  }
  const Eigen::Vector3f slant = direction - triangle.normal * triangle.normal.dot(direction);
  const float sine = slant.norm();
  const Eigen::Vector3f edge = (triangle.corners[1] - triangle.corners[0]).normalized();
  const Eigen::Vector3f along = sine > 1e-4F ? Eigen::Vector3f(slant / sine) : edge;
  const Eigen::Vector3f across = triangle.normal.cross(along);
  footprint.diameters = {weights_along(triangle, along * (ray.footprint / limited)),
                         weights_along(triangle, across * ray.footprint)};
  return footprint;
}

SampleFootprint footprint_of(const SurfaceTriangle& triangle, const SurfaceRay& ray) {
  return footprint_of(triangle, ray, triangle.mesh->is_textured ? slant_cosine(triangle, ray) : 1);
}

Eigen::Vector3f emission_of(const SurfaceTriangle& triangle, const SampleFootprint& footprint) {
  Eigen::Vector3f emission = triangle.mesh->material->emission;
  if (triangle.emissive.texture != nullptr) {
    emission.array() *= triangle.emissive.color(footprint).head<3>().array();
  }
  return emission;
}

/// Sets a point's dielectric reflection as KHR_materials_specular and KHR_materials_ior say.
void read_specular(const SurfaceTriangle& triangle, const SampleFootprint& footprint,
                   SurfacePoint& point) {
  const Material& material = *triangle.mesh->material;
  point.specular =
      material.specular * extension_texel(triangle, material.specular_texture, footprint).w();
  const Eigen::Vector3f color = material.specular_color.cwiseProduct(
      extension_texel(triangle, material.specular_color_texture, footprint).head<3>());
  point.normal_reflectance = (normal_reflectance(material.ior) * color).cwiseMin(1);
}

float clearcoat_at(const SurfaceTriangle& triangle, const SampleFootprint& footprint) {
  const MaterialLayers& layers = triangle.mesh->material->layers;
  return layers.clearcoat * extension_texel(triangle, layers.clearcoat_texture, footprint).x();
}

/// Sets a point's transmission and clear coat; its coat's normal is that of the vertices before.
void read_layers(const SurfaceTriangle& triangle, const SampleFootprint& footprint,
                 SurfacePoint& point) {
  const MaterialLayers& layers = triangle.mesh->material->layers;
  point.transmission =
      layers.transmission * extension_texel(triangle, layers.transmission_texture, footprint).x();
  point.clearcoat = clearcoat_at(triangle, footprint);
  point.clearcoat_roughness =
      layers.clearcoat_roughness *
      extension_texel(triangle, layers.clearcoat_roughness_texture, footprint).y();
}

/// Sets a point's material values from the material's factors and textures.
void read_maps(const SurfaceTriangle& triangle, const SampleFootprint& footprint,
               SurfacePoint& point) {
  const Material& material = *triangle.mesh->material;
  const Eigen::Vector4f color = color_of(triangle, footprint);
  point.base_color = color.head<3>();
  point.alpha = color.w();
  point.emission = emission_of(triangle, footprint);
  point.metallic = material.metallic;
  point.roughness = material.roughness;
  if (triangle.metallic_roughness.texture != nullptr) {
    const Eigen::Vector4f texel = triangle.metallic_roughness.color(footprint);
    point.roughness *= texel.y();
    point.metallic *= texel.z();
  }
  if (triangle.occlusion.texture != nullptr) {
    const float texel = triangle.occlusion.color(footprint).x();
    point.openness = 1 + material.occlusion_strength * (texel - 1);
  }
  read_specular(triangle, footprint, point);
  if (material.layers.any()) {
    read_layers(triangle, footprint, point);
  }
}

/// Returns the normal of a surface with area, on the triangle's front, before any map.
Eigen::Vector3f front_normal(const SurfaceTriangle& triangle, const Eigen::Vector3f& weights) {
  const Eigen::Vector3f normal = vertex_normal(triangle, weights);
  return normal.dot(triangle.normal) < 0 ? Eigen::Vector3f(-normal) : normal;
}

/// Returns the normal of the clear coat on the triangle's front; `smooth` is that of the vertices.
Eigen::Vector3f coat_normal_of(const SurfaceTriangle& triangle, const SampleFootprint& footprint,
                               const Eigen::Vector3f& smooth) {
  const MaterialLayers& layers = triangle.mesh->material->layers;
  if (layers.clearcoat == 0) {
    return smooth;
  }
  const TexturePatch patch = extension_patch(triangle, layers.clearcoat_normal_texture);
  return patch.texture == nullptr
             ? smooth
             : mapped_normal(triangle, {patch, layers.clearcoat_normal_scale}, footprint, smooth);
}

/// Sets a point's normals, which face the viewer.
void set_normals(const SurfaceTriangle& triangle, const SampleFootprint& footprint,
                 SurfacePoint& point) {
  if (triangle.normal.isZero(0)) {
    point.face_normal = point.to_viewer;
    point.normal = point.to_viewer;
    point.coat_normal = point.to_viewer;
    return;
  }
  const float side = point.is_from_behind ? -1.0F : 1.0F;
  const Eigen::Vector3f smooth = front_normal(triangle, footprint.weights);
  const NormalMap map{triangle.normal_map, triangle.mesh->material->normal_scale};
  point.face_normal = side * triangle.normal;
  point.coat_normal = side * coat_normal_of(triangle, footprint, smooth);
  point.normal =
      side *
      (map.patch.texture == nullptr ? smooth : mapped_normal(triangle, map, footprint, smooth));
}

}  // namespace

SurfaceTriangle::SurfaceTriangle(const WorldGeometry& world, int mesh_index, int triangle,
                                 float share, SurfaceMaps maps) {
  const MomentPair moments = moments_around(world.meshes[mesh_index], share);
  mesh = moments.before;
  vertices = mesh->mesh->triangles[triangle];
  corners = corners_of(world.meshes[mesh_index], triangle, share);
  for (std::size_t i = 0; i < 3 && mesh->has_normals(); ++i) {
    normals[i] = normal_between(moments, vertices[i]);
  }
  const Eigen::Vector3f cross =
      mesh->side * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const float length = cross.norm();
  const bool has_area = length > std::numeric_limits<float>::min();
  normal = has_area ? Eigen::Vector3f(cross / length) : Eigen::Vector3f::Zero();
  double_area = has_area ? length : 0;
  scene = world.scene;
  rounding = 16 * std::numeric_limits<float>::epsilon() * extent_of(world, *this);
  const Material& material = *mesh->material;
  const auto patch = [&](const TextureSlot& slot) {
    return texture_patch(*scene, *mesh, slot, vertices, double_area);
  };
  base_color = patch(material.base_color_texture);
  if (maps == SurfaceMaps::color) {
    return;
  }
  metallic_roughness = patch(material.metallic_roughness_texture);
  normal_map = patch(material.normal_texture);
  occlusion = patch(material.occlusion_texture);
  emissive = patch(material.emissive_texture);
}

Eigen::Vector4f surface_color(const SurfaceTriangle& triangle, const SurfaceRay& ray) {
  return color_of(triangle, footprint_of(triangle, ray));
}

Eigen::Vector3f surface_emission(const SurfaceTriangle& triangle, const SurfaceRay& ray) {
  return emission_of(triangle, footprint_of(triangle, ray));
}

float surface_clearcoat(const SurfaceTriangle& triangle, const SurfaceRay& ray) {
  return clearcoat_at(triangle, footprint_of(triangle, ray));
}

SurfacePoint surface_point(const SurfaceTriangle& triangle, const SurfaceRay& ray) {
  SurfacePoint point;
  point.position = interpolate(triangle.corners, kCorners, ray.weights);
  point.share = ray.share;
  point.to_viewer = -ray.direction.normalized();
  point.rounding = triangle.rounding;
  const float slant = triangle.normal.dot(point.to_viewer);
  point.is_from_behind = slant < 0;
  const SampleFootprint footprint = footprint_of(triangle, ray, std::abs(slant));
  set_normals(triangle, footprint, point);
  read_maps(triangle, footprint, point);
  return point;
}

SurfacePoint surface_point(const WorldGeometry& world, const SurfaceHit& hit,
                           const Eigen::Vector3f& view_direction, float footprint) {
  return surface_point(SurfaceTriangle(world, hit.mesh, hit.triangle),
                       {hit.weights, view_direction, footprint});
}

float surface_alpha(const WorldGeometry& world, const SurfaceHit& hit) {
  const FlatMesh& mesh = world.meshes[hit.mesh];
  const Material& material = *mesh.material;
  const std::array<int, 3>& vertices = mesh.mesh->triangles[hit.triangle];
  float alpha = material.base_color.w();
  const TexturePatch patch =
      texture_patch(*world.scene, mesh, material.base_color_texture, vertices, 1);
  if (patch.texture != nullptr) {
    const float sharpest = -std::numeric_limits<float>::infinity();
    alpha *= patch.color({hit.weights, sharpest}).w();
  }
  if (!mesh.mesh->colors.empty()) {
    alpha *= interpolate(mesh.mesh->colors, vertices, hit.weights).w();
  }
  return alpha;
}

}  // namespace synth
