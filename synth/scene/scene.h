#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "synth/scene/motion.h"
#include "vo/geometry/se3.h"

namespace synth {

inline constexpr int kNone = -1;  ///< "no such element" for the indices below

/// An index that is not kNone, as containers take it.
constexpr std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/// What the numbers of an image's colour channels mean; alpha is linear always.
enum class TexelEncoding { srgb, linear };

/// An image with all its mip levels; levels[0] is the full image, the last is 1x1.
struct TextureImage {
  std::vector<cv::Mat_<cv::Vec4b>> levels;       ///< RGBA
  TexelEncoding encoding = TexelEncoding::srgb;  ///< linear: normals, roughness and their like
};

enum class Wrap { repeat, clamp_to_edge, mirrored_repeat };
enum class TexelFilter { nearest, linear };
enum class MipFilter { none, nearest, linear };

/// How an image is looked up (glTF's sampler).
struct Texture {
  int image = kNone;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  TexelFilter magnification = TexelFilter::linear;
  TexelFilter minification = TexelFilter::linear;
  MipFilter mip = MipFilter::linear;
};

/// A texture as a material uses it.
struct TextureSlot {
  int texture = kNone;
  int texcoord_set = 0;  ///< of Mesh::texcoords; a mesh without that set shows no texture
  Eigen::Affine2f T_image_texcoord = Eigen::Affine2f::Identity();  ///< KHR_texture_transform
};

enum class AlphaMode { opaque, mask, blend };

/// glTF's metallic-roughness model. Each factor is multiplied by its texture, if there is one. The
/// defaults are a white diffuse surface.
struct Material {
  std::string name;
  Eigen::Vector4f base_color = Eigen::Vector4f::Ones();  ///< linear RGBA
  TextureSlot base_color_texture;
  float metallic = 0;   ///< 0 to 1; blue channel of the texture
  float roughness = 1;  ///< 0 to 1, square root of GGX's alpha; green channel of the texture
  TextureSlot metallic_roughness_texture;
  float specular = 0;             ///< 0 to 1, of the reflection of what is not metal; glTF's is 1
  TextureSlot normal_texture;     ///< linear, 2 c - 1, in the frame of tangents
  float normal_scale = 1;         ///< of the normal's x and y
  TextureSlot occlusion_texture;  ///< red channel: share of the ambient light that arrives
  float occlusion_strength = 1;   ///< 0 to 1
  Eigen::Vector3f emission = Eigen::Vector3f::Zero();  ///< linear RGB, strength included
  TextureSlot emissive_texture;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5F;  ///< `mask`: less alpha is not there
  bool double_sided = false;  ///< false: seen from the side that its triangles' corners run about
                              ///< against the clock
  bool unlit = false;         ///< shows its base colour as it is
};

inline constexpr int kTexcoordSets = 2;

/// Triangles of one material in a frame of their own. All per-vertex arrays but `positions` may be
/// empty; those that are not have one element per vertex.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;  ///< m
  std::vector<Eigen::Vector3f> normals;    ///< unit
  std::vector<Eigen::Vector4f> tangents;   ///< unit, and +-1: bitangent = w cross(normal, tangent)
  /// TEXCOORD_0 and _1, glTF's: (0, 0) is the image's top-left corner.
  std::array<std::vector<Eigen::Vector2f>, kTexcoordSets> texcoords;
  std::vector<Eigen::Vector4f> colors;        ///< linear RGBA
  std::vector<std::array<int, 3>> triangles;  ///< vertex indices, all in range
  int material = kNone;
};

/// A mesh put into the world.
struct Instance {
  int mesh = kNone;
  Eigen::Affine3d T_world_mesh = Eigen::Affine3d::Identity();  ///< any scale, mirroring included
};

enum class LightKind { point, directional, spot };

/// KHR_lights_punctual.
struct Light {
  LightKind kind = LightKind::point;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();     ///< m, world; not of directional ones
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitY();  ///< unit, world, of travel; not of points
  Eigen::Vector3f intensity =
      Eigen::Vector3f::Ones();  ///< linear RGB; cd (point, spot), lx (directional)
  double range = std::numeric_limits<double>::infinity();  ///< m, where its light has faded
  double inner_cone = 0;                                   ///< rad off `direction`: full light
  double outer_cone = std::numbers::pi / 4;                ///< rad off `direction`: no light
};

/// A camera that the file suggests to look from.
struct SceneCamera {
  std::string name;
  vo::SE3 T_world_camera;   ///< x right, y down, z forward
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
  SceneMotion motion;  ///< how it leaves its rest; empty where nothing moves
};

}  // namespace synth
