#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "tools/make_scenes/painting/texture_painter.h"

namespace scenes {

/// The material that a surface is made of.
enum class Finish {
  floor,
  ceiling,
  brick,
  plain_wall,
  wallpaper,
  tiles,
  white_paint,
  oak,
  pine,
  walnut,
  marble,
  sofa_fabric,
  ochre_fabric,
  rust_fabric,
  linen,
  rug,
  carpet,
  brass,
  steel,
  black_plastic,
  porcelain,
  glaze,
  terracotta,
  leaf,
  soil,
  cardboard,
  paint,
  print,
  book_spines,
  paper,
  shapes_poster,
  ridges_poster,
  painting,
  map,
  globe,
  clock,
  screen,
  view,
  lamp_glow,
  lamp_shade,
  white_wall,
  white_floor,
  mosaic,
  mosaic_box,
  linoleum,
  ceiling_panels,
  door_paint,
  exit_sign,
  page,
  handwriting,
  cork,
  ruler,
  checker,
  grey_plastic,
  crate,
  ball,
  tartan,
  trousers,
  skin,
  hair,
  window_glass,
  mirror,
  polished_steel,
  brushed_steel,
  black_glass,
  light_panel,
};

enum class Wrap { repeat = 10497, clamp_to_edge = 33071, mirrored_repeat = 33648 };
enum class Magnification { nearest = 9728, linear = 9729 };
enum class Minification {
  linear = 9729,
  nearest_mipmap_nearest = 9984,
  linear_mipmap_nearest = 9985,
  linear_mipmap_linear = 9987,
};

/// A glTF texture sampler; the enumerators have glTF's values.
struct Sampler {
  Wrap wrap = Wrap::repeat;
  Magnification magnification = Magnification::linear;
  Minification minification = Minification::linear_mipmap_linear;

  bool operator==(const Sampler&) const = default;
};

struct Material {
  std::string name;
  Color color = Color::Ones();                     ///< linear RGB; multiplies the texture
  std::string image;                               ///< name of its texture's image; empty = none
  Eigen::Vector2d tile = Eigen::Vector2d::Ones();  ///< m (or share of 0..1) the image covers
  Sampler sampler;
  Color emission = Color::Zero();  ///< linear RGB, above 1 where it lights a room
  bool unlit = false;
  bool double_sided = false;
  double metallic = 0;
  double roughness = 1;
  double transmission = 0;  ///< of a thin wall
};

/// Returns the material of each Finish, in the enumerators' order.
std::vector<Material> materials();

struct NamedImage {
  std::string name;
  cv::Mat (*paint)();
};

/// Returns all images that materials() refers to.
std::vector<NamedImage> images();

}  // namespace scenes
