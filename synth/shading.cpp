#include "synth/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "synth/texture.h"

namespace synth {
namespace {

/// Beyond this slant a texture is not blurred further.
constexpr float kMinCosine = 0.05F;

struct Face {
  Eigen::Vector3f normal;  ///< unit, towards the viewer
  float double_area;       ///< m^2
};

Face face_of(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::Vector3f& view) {
  const Eigen::Vector3f cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const float length = cross.norm();
  if (!(length > std::numeric_limits<float>::min())) {
    return {-view, 0};
  }
  const float side = cross.dot(view) > 0 ? -1.0F : 1.0F;
  return {cross * (side / length), length};
}

template <typename T>
T interpolate(const std::vector<T>& values, const std::array<int, 3>& triangle,
              const Eigen::Vector3f& weights) {
  return values[triangle[0]] * weights[0] + values[triangle[1]] * weights[1] +
         values[triangle[2]] * weights[2];
}

Eigen::Vector3f shading_normal(const FlatMesh& mesh, const std::array<int, 3>& triangle,
                               const Eigen::Vector3f& weights, const Eigen::Vector3f& face_normal) {
  if (mesh.normals.empty()) {
    return face_normal;
  }
  constexpr float kMinLength = 1e-3F;  // shorter: opposite normals that cancel out
  const Eigen::Vector3f normal = interpolate(mesh.normals, triangle, weights);
  const float length = normal.norm();
  if (!(length > kMinLength)) {
    return face_normal;
  }
  return normal * ((normal.dot(face_normal) < 0 ? -1.0F : 1.0F) / length);
}

/// Level of detail at which a texel is as wide as the sample, for an even mapping of the triangle.
float texture_lod(const std::array<Eigen::Vector2f, 3>& uv, const cv::Size& texels,
                  float double_area, float footprint) {
  const Eigen::Vector2f a = uv[1] - uv[0];
  const Eigen::Vector2f b = uv[2] - uv[0];
  const float texel_area = std::abs(a.x() * b.y() - a.y() * b.x()) *
                           static_cast<float>(texels.width) * static_cast<float>(texels.height);
  return 0.5F * std::log2(texel_area / double_area * footprint * footprint);
}

/// One where there is no texture.
Eigen::Vector4f texture_color(const Scene& scene, const Mesh& mesh, const TextureSlot& slot,
                              const SurfaceHit& hit, float double_area, float footprint) {
  if (slot.texture == kNone || scene.textures[slot.texture].image == kNone ||
      mesh.texcoords[slot.texcoord_set].empty()) {
    return Eigen::Vector4f::Ones();
  }
  const std::array<int, 3>& triangle = mesh.triangles[hit.triangle];
  std::array<Eigen::Vector2f, 3> uv;
  for (int i = 0; i < 3; ++i) {
    uv[i] = slot.T_image_texcoord * mesh.texcoords[slot.texcoord_set][triangle[i]];
  }
  const Texture& texture = scene.textures[slot.texture];
  const TextureImage& image = scene.images[texture.image];
  const Eigen::Vector2f middle =
      uv[0] * hit.weights[0] + uv[1] * hit.weights[1] + uv[2] * hit.weights[2];
  return sample(image, texture, middle,
                texture_lod(uv, image.levels[0].size(), double_area, footprint));
}

Eigen::Vector3f base_color(const Scene& scene, const FlatMesh& flat, const SurfaceHit& hit,
                           float double_area, float footprint) {
  const Mesh& mesh = *flat.mesh;
  Eigen::Vector4f color = flat.material->base_color;
  color.array() *=
      texture_color(scene, mesh, flat.material->base_color_texture, hit, double_area, footprint)
          .array();
  if (!mesh.colors.empty()) {
    color.array() *= interpolate(mesh.colors, mesh.triangles[hit.triangle], hit.weights).array();
  }
  return color.head<3>();
}

Eigen::Vector3f emission(const Scene& scene, const FlatMesh& flat, const SurfaceHit& hit,
                         float double_area, float footprint) {
  const Material& material = *flat.material;
  if (material.emission.isZero(0)) {
    return material.emission;
  }
  const Eigen::Vector4f texel =
      texture_color(scene, *flat.mesh, material.emissive_texture, hit, double_area, footprint);
  return material.emission.cwiseProduct(texel.head<3>());
}

/// The share of a point light's flux that meets the box, outside of it taken as a sphere of the
/// same surface about the box's middle.
double share_received(const Eigen::AlignedBox3d& box, double surface,
                      const Eigen::Vector3d& position) {
  if (box.contains(position)) {
    return 1;
  }
  const double radius2 = surface / (4 * std::numbers::pi);
  const double distance2 = (position - box.center()).squaredNorm();
  return (1 - std::sqrt(1 - std::min(1.0, radius2 / distance2))) / 2;
}

/// Irradiance, lx, if the flux that enters the box spread evenly over its surface.
Eigen::Vector3d mean_irradiance(const std::vector<Light>& lights, const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d size = box.sizes();
  const double surface = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Light& light : lights) {
    const Eigen::Vector3d intensity = light.intensity.cast<double>();
    if (light.kind == LightKind::directional) {
      sum += intensity / 4;  // a convex body's shadow is a quarter of its surface on average
    } else if (surface > 0) {
      sum += intensity * (4 * std::numbers::pi * share_received(box, surface, light.position)) /
             surface;
    }
  }
  return sum;
}

/// For scenes without lights: at its brightest a surface shows its base colour.
AmbientLight default_sky(double share) {
  const double sky = std::numbers::pi / (1 + share / 2);
  AmbientLight light;
  light.uniform.setConstant(static_cast<float>(sky * share / 2));
  light.sky.setConstant(static_cast<float>(sky));
  light.sky_axis = Eigen::Vector3f(0.3F, 1.0F, 0.5F).normalized();
  return light;
}

}  // namespace

SurfacePoint surface_point(const FlatScene& flat, const SurfaceHit& hit,
                           const Eigen::Vector3f& view_direction, float footprint) {
  const FlatMesh& mesh = flat.meshes[hit.mesh];
  const std::array<int, 3>& triangle = mesh.mesh->triangles[hit.triangle];
  const std::array<Eigen::Vector3f, 3> corners = {
      mesh.positions[triangle[0]], mesh.positions[triangle[1]], mesh.positions[triangle[2]]};
  const Eigen::Vector3f view = view_direction.normalized();
  const Face face = face_of(corners, view);

  SurfacePoint point;
  point.position = interpolate(mesh.positions, triangle, hit.weights);
  point.face_normal = face.normal;
  point.normal = shading_normal(mesh, triangle, hit.weights, face.normal);
  const float cosine = std::max(kMinCosine, -view.dot(face.normal));
  point.base_color = base_color(*flat.scene, mesh, hit, face.double_area, footprint / cosine);
  point.emission = emission(*flat.scene, mesh, hit, face.double_area, footprint / cosine);
  const Eigen::Array3f extent =
      corners[0].array().abs().max(corners[1].array().abs()).max(corners[2].array().abs());
  point.rounding = 16 * std::numeric_limits<float>::epsilon() * extent.maxCoeff();
  return point;
}

Eigen::Vector3f AmbientLight::irradiance(const Eigen::Vector3f& normal) const {
  return uniform + sky * (0.5F + 0.5F * normal.dot(sky_axis));
}

AmbientLight ambient_light(const FlatScene& flat, double share) {
  if (flat.scene->lights.empty()) {
    return default_sky(share);
  }
  const Eigen::AlignedBox3d box = lit_bounds(flat);
  AmbientLight light;
  if (!box.isEmpty()) {
    light.uniform = (share * mean_irradiance(flat.scene->lights, box)).cast<float>();
  }
  return light;
}

DirectLight direct_light(const Light& light, const Eigen::Vector3f& position,
                         const SurfacePoint& point) {
  const bool is_point = light.kind != LightKind::directional;
  const Eigen::Vector3f to_light =
      is_point ? Eigen::Vector3f(position - point.position) : -light.direction.cast<float>();
  const float along_normal = to_light.dot(point.normal);
  if (!(along_normal > 0) || to_light.dot(point.face_normal) <= 0) {
    return {to_light, Eigen::Vector3f::Zero()};
  }
  const float distance = is_point ? to_light.norm() : 1;
  return {to_light, light.intensity * (along_normal / (distance * distance * distance))};
}

}  // namespace synth
