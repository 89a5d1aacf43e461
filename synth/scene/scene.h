#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "synth/scene/motion.h"
#include "vo/geometry/se3.h"

namespace synth {

inline constexpr int kNone = -1;  ///< index that refers to no element

/// Converts an index that is not kNone to the type that containers take.
constexpr std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/// The encoding of an image's colour channels; alpha is always linear.
enum class TexelEncoding { srgb, linear };

/// An image with all its mip levels; levels[0] is the full image, the last is 1x1.
struct TextureImage {
  std::vector<cv::Mat_<cv::Vec4b>> levels;       ///< 8-bit RGBA
  TexelEncoding encoding = TexelEncoding::srgb;  ///< linear for data such as normals and roughness
};

enum class Wrap { repeat, clamp_to_edge, mirrored_repeat };
enum class TexelFilter { nearest, linear };
enum class MipFilter { none, nearest, linear };

/// An image and how it is sampled (glTF's texture and sampler).
struct Texture {
  int image = kNone;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  TexelFilter magnification = TexelFilter::linear;
  TexelFilter minification = TexelFilter::linear;
  MipFilter mip = MipFilter::linear;
};

/// A material's reference to a texture (glTF's textureInfo).
struct TextureSlot {
  int texture = kNone;
  int texcoord_set = 0;  ///< index into Mesh::texcoords; a mesh without it shows no texture
  Eigen::Affine2f T_image_texcoord = Eigen::Affine2f::Identity();  ///< KHR_texture_transform
};

enum class AlphaMode { opaque, mask, blend };

/// The layers that KHR_materials_transmission, _volume and _clearcoat give a material. Mode `path`
/// of the ray tracer alone draws them. Each factor is multiplied by its texture, if there is one.
struct MaterialLayers {
  float transmission = 0;  ///< 0 to 1, of the light that enters a dielectric what passes through
  TextureSlot transmission_texture;  ///< red channel
  bool is_solid = false;  ///< encloses a body that refracts; if false, transmits as a thin wall
  Eigen::Vector3f attenuation_color = Eigen::Vector3f::Ones();  ///< linear RGB
  /// m in the body, after which white light has the attenuation colour
  float attenuation_distance = std::numeric_limits<float>::infinity();
  float clearcoat = 0;                      ///< 0 to 1, strength of the coat
  TextureSlot clearcoat_texture;            ///< red channel
  float clearcoat_roughness = 0;            ///< 0 to 1, of the coat; square root of GGX's alpha
  TextureSlot clearcoat_roughness_texture;  ///< green channel
  TextureSlot clearcoat_normal_texture;     ///< of the coat, as Material::normal_texture
  float clearcoat_normal_scale = 1;         ///< factor of the mapped normal's x and y

  bool any() const { return transmission > 0 || clearcoat > 0; }
};

/// A material of glTF's metallic-roughness model. Each factor is multiplied by its texture, if
/// there is one. The defaults give a white diffuse surface.
struct Material {
  std::string name;
  Eigen::Vector4f base_color = Eigen::Vector4f::Ones();  ///< linear RGBA
  TextureSlot base_color_texture;
  float metallic = 0;   ///< 0 to 1; times the texture's blue channel
  float roughness = 1;  ///< 0 to 1, square root of GGX's alpha; times the texture's green channel
  TextureSlot metallic_roughness_texture;
  float specular = 0;            ///< 0 to 1, strength of dielectric reflection; 1 in glTF
  TextureSlot specular_texture;  ///< alpha channel, times `specular`
  /// Linear RGB, 0 or more, factor of what a dielectric reflects along its normal, at most all.
  Eigen::Vector3f specular_color = Eigen::Vector3f::Ones();
  TextureSlot specular_color_texture;
  float ior = 1.5F;               ///< index of refraction, 1 or more; 0 reflects all that arrives
  TextureSlot normal_texture;     ///< tangent-space normal 2 c - 1 of linear texels c
  float normal_scale = 1;         ///< factor of the mapped normal's x and y
  TextureSlot occlusion_texture;  ///< red channel: fraction of ambient light that arrives
  float occlusion_strength = 1;   ///< 0 to 1; 0 ignores the occlusion texture
  Eigen::Vector3f emission = Eigen::Vector3f::Zero();  ///< linear RGB, emissive strength included
  TextureSlot emissive_texture;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5F;  ///< `mask`: less alpha is fully transparent
  bool double_sided = false;  ///< if false, only the counter-clockwise side is meant to be seen
  bool unlit = false;         ///< KHR_materials_unlit: shows the base colour unshaded
  MaterialLayers layers;      ///< none if unlit
};

/// Returns pointers to every texture slot that a material, constant or not, may use.
template <typename AnyMaterial>
auto all_texture_slots(AnyMaterial& material) {
  auto& layers = material.layers;
  return std::array{&material.base_color_texture,    &material.metallic_roughness_texture,
                    &material.specular_texture,      &material.specular_color_texture,
                    &material.normal_texture,        &material.occlusion_texture,
                    &material.emissive_texture,      &layers.transmission_texture,
                    &layers.clearcoat_texture,       &layers.clearcoat_roughness_texture,
                    &layers.clearcoat_normal_texture};
}

inline constexpr int kTexcoordSets = 2;

/// Triangles of one material in a coordinate frame of their own. Per-vertex arrays have one element
/// per vertex; all but `positions` may be empty.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;  ///< m
  std::vector<Eigen::Vector3f> normals;    ///< unit
  std::vector<Eigen::Vector4f> tangents;   ///< unit, w = +-1: bitangent = w cross(normal, tangent)
  /// glTF's TEXCOORD_0 and TEXCOORD_1: (0, 0) is the image's top-left corner.
  std::array<std::vector<Eigen::Vector2f>, kTexcoordSets> texcoords;
  std::vector<Eigen::Vector4f> colors;        ///< linear RGBA
  std::vector<std::array<int, 3>> triangles;  ///< vertex indices, all in range
  int material = kNone;
};

/// A mesh placed in the world.
struct Instance {
  int mesh = kNone;
  Eigen::Affine3d T_world_mesh = Eigen::Affine3d::Identity();  ///< any scale, also mirroring
};

enum class LightKind { point, directional, spot };

constexpr auto enum_names(LightKind) {
  return std::array{std::pair{LightKind::point, "point"},
                    std::pair{LightKind::directional, "directional"},
                    std::pair{LightKind::spot, "spot"}};
}

/// A light of KHR_lights_punctual.
struct Light {
  LightKind kind = LightKind::point;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, world; unused if directional
  Eigen::Vector3d direction =
      -Eigen::Vector3d::UnitY();  ///< unit, world, of travel; unused if point
  Eigen::Vector3f intensity =
      Eigen::Vector3f::Ones();  ///< linear RGB; cd (point, spot), lx (directional)
  double range = std::numeric_limits<double>::infinity();  ///< m, at which the light fades to zero
  double inner_cone = 0;                                   ///< rad, half-angle of the full light
  double outer_cone = std::numbers::pi / 4;                ///< rad, half-angle where the light ends
};

/// Light from infinitely far as an equirectangular image, twice as wide as high: rows from straight
/// up to straight down, columns clockwise as seen from above, the middle one towards -z.
struct Environment {
  cv::Mat_<cv::Vec3f> radiance;  ///< linear RGB; empty where there is none
  double turn = 0;               ///< rad about +y, by which the image is turned

  bool empty() const { return radiance.empty(); }
};

/// A viewpoint that the scene's file provides.
struct SceneCamera {
  std::string name;
  vo::SE3 T_world_camera;   ///< camera axes x right, y down, z forward
  double vertical_fov = 0;  ///< rad; 0 = orthographic
  double aspect_ratio = 0;  ///< width / height; 0 = any
};

/// A scene at rest, in glTF's world: right-handed, y up, metres. Elements refer to each other by
/// index; every index is in range or kNone.
struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<TextureImage> images;
  std::vector<Light> lights;
  std::vector<SceneCamera> cameras;
  SceneMotion motion;       ///< animations of the scene; empty if nothing moves
  Environment environment;  ///< light from infinitely far; none in most scenes
};

}  // namespace synth
