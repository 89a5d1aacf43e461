#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace synth {

inline constexpr int kNone = -1;  ///< "no such element" for the indices below

/// An image with all its mip levels; levels[0] is the full image, the last is 1x1.
struct TextureImage {
  std::vector<cv::Mat_<cv::Vec4b>> levels;  ///< RGBA, colour sRGB-encoded, alpha linear
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

struct Material {
  Eigen::Vector4f base_color = Eigen::Vector4f::Ones();  ///< linear RGBA
  int base_color_texture = kNone;
  Eigen::Vector3f emission = Eigen::Vector3f::Zero();  ///< linear RGB
  bool unlit = false;                                  ///< shows its base colour as it is
};

/// Triangles of one material in a frame of their own. All per-vertex arrays but `positions` may be
/// empty; those that are not have one element per vertex.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;     ///< m
  std::vector<Eigen::Vector3f> normals;       ///< unit
  std::vector<Eigen::Vector2f> texcoords;     ///< glTF's: (0, 0) is the image's top-left corner
  std::vector<Eigen::Vector4f> colors;        ///< linear RGBA
  std::vector<std::array<int, 3>> triangles;  ///< vertex indices, all in range
  int material = kNone;
};

/// A mesh put into the world.
struct Instance {
  int mesh = kNone;
  Eigen::Affine3d T_world_mesh = Eigen::Affine3d::Identity();  ///< any scale, mirroring included
};

enum class LightKind { point, directional };

struct Light {
  LightKind kind = LightKind::point;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();     ///< m, world; point lights
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitY();  ///< unit, world, of travel; directional
  Eigen::Vector3f intensity =
      Eigen::Vector3f::Ones();  ///< linear RGB; cd (point), lx (directional)
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
};

}  // namespace synth
