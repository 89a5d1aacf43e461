#include "tools/make_scenes/painting/finish.h"

#include <numbers>

#include "tools/make_scenes/painting/picture_patterns.h"
#include "tools/make_scenes/painting/print_patterns.h"
#include "tools/make_scenes/painting/surface_patterns.h"

namespace scenes {
namespace {

constexpr Sampler kClamped = {.wrap = Wrap::clamp_to_edge};
constexpr Sampler kMirrored = {.wrap = Wrap::mirrored_repeat};
constexpr Sampler kCrispPixels = {.wrap = Wrap::clamp_to_edge,
                                  .magnification = Magnification::nearest};
constexpr Sampler kOneLevel = {.minification = Minification::linear_mipmap_nearest};

Material plain(const std::string& name, const Color& color) {
  return {name, color, "", {1, 1}, {}};
}

Material textured(const std::string& name, const Color& tint, const std::string& image,
                  const Eigen::Vector2d& tile, const Sampler& sampler = {}) {
  return {name, tint, image, tile, sampler};
}

Material picture(const std::string& name) {
  return textured(name, Color::Ones(), name, {1, 1}, kClamped);
}

Material two_sided(Material material) {
  material.double_sided = true;
  return material;
}

Material glowing(Material material, const Color& emission) {
  material.emission = emission;
  return material;
}

Material unlit(Material material) {
  material.unlit = true;
  return material;
}

std::vector<Material> building_materials() {
  return {
      textured("floor", {0.8, 0.8, 0.8}, "floor_planks", {2.4, 1.6}),
      textured("ceiling", {0.84, 0.83, 0.8}, "plaster", {1.6, 1.6}, kMirrored),
      textured("brick", {0.9, 0.9, 0.9}, "brick", {2.5, 0.75}),
      textured("plain_wall", {0.74, 0.7, 0.62}, "plaster", {1.6, 1.6}, kMirrored),
      textured("wallpaper", {1, 1, 1}, "wallpaper", {0.4, 0.4}),
      textured("tiles", {0.9, 0.9, 0.9}, "tiles", {0.3, 0.3}),
      textured("white_paint", {0.75, 0.74, 0.7}, "plaster", {0.7, 0.7}, kMirrored),
      textured("oak", {0.62, 0.4, 0.21}, "wood", {0.8, 0.4}),
      textured("pine", {0.82, 0.62, 0.38}, "wood", {1.0, 0.5}, kOneLevel),
      textured("walnut", {0.27, 0.15, 0.085}, "wood", {0.8, 0.4}),
      textured("marble", {0.9, 0.89, 0.87}, "marble", {0.6, 0.6}, kMirrored),
  };
}

std::vector<Material> soft_materials() {
  return {
      textured("sofa_fabric", {0.13, 0.2, 0.29}, "fabric", {0.2, 0.2}),
      textured("ochre_fabric", {0.62, 0.37, 0.09}, "fabric", {0.16, 0.16}),
      textured("rust_fabric", {0.45, 0.13, 0.08}, "fabric", {0.16, 0.16}),
      two_sided(textured("linen", {0.86, 0.8, 0.68}, "fabric", {0.2, 0.2})),
      textured("rug", {1, 1, 1}, "rug", {2.2, 1.6}, kClamped),
      textured("carpet", {0.34, 0.3, 0.25}, "carpet", {0.2, 0.2},
               {.magnification = Magnification::nearest,
                .minification = Minification::nearest_mipmap_nearest}),
  };
}

std::vector<Material> small_materials() {
  return {
      plain("brass", {0.6, 0.43, 0.17}),
      plain("steel", {0.5, 0.51, 0.53}),
      plain("black_plastic", {0.03, 0.03, 0.034}),
      plain("porcelain", {0.8, 0.79, 0.76}),
      plain("glaze", {0.09, 0.3, 0.32}),
      textured("terracotta", {0.62, 0.27, 0.15}, "plaster", {0.3, 0.3}, kMirrored),
      two_sided(textured("leaf", {0.9, 0.9, 0.9}, "leaf", {1, 1}, kClamped)),
      textured("soil", {0.08, 0.055, 0.04}, "carpet", {0.12, 0.12}),
      textured("cardboard", {0.56, 0.38, 0.21}, "cardboard", {0.5, 0.5}),
      plain("paint", {1, 1, 1}),
      textured("print", {0.95, 0.95, 0.95}, "label", {1, 1}, kClamped),
      textured("book_spines", {0.95, 0.95, 0.95}, "book_spines", {1, 1}, kClamped),
      plain("paper", {0.75, 0.71, 0.6}),
  };
}

std::vector<Material> picture_materials() {
  const double radius = 0.14;
  return {
      picture("shapes_poster"),
      picture("ridges_poster"),
      picture("painting"),
      picture("map"),
      textured("globe", {1, 1, 1}, "map", Eigen::Vector2d(2, 1) * std::numbers::pi * radius),
      picture("clock"),
      unlit(textured("screen", {0.6, 0.6, 0.6}, "screen", {1, 1}, kCrispPixels)),
      unlit(textured("view", {0.9, 0.9, 0.9}, "view", {0.5, 1},
                     {.wrap = Wrap::mirrored_repeat, .minification = Minification::linear})),
      glowing(plain("lamp_glow", {0.9, 0.88, 0.8}), {1, 0.92, 0.75}),
      two_sided(glowing(textured("lamp_shade", {0.8, 0.72, 0.58}, "fabric", {0.2, 0.2}),
                        {0.16, 0.12, 0.07})),
  };
}

std::vector<Material> test_materials() {
  return {
      plain("white_wall", {0.8, 0.8, 0.79}),
      plain("white_floor", {0.72, 0.72, 0.72}),
      unlit(picture("mosaic")),
      unlit(picture("mosaic_box")),
      textured("linoleum", {0.85, 0.85, 0.85}, "linoleum", {1.2, 1.2}),
      textured("ceiling_panels", {0.86, 0.86, 0.85}, "ceiling_panels", {0.6, 0.6}),
      textured("door_paint", {0.2, 0.32, 0.42}, "plaster", {0.7, 0.7}, kMirrored),
      unlit(picture("exit_sign")),
      two_sided(picture("page")),
      two_sided(picture("handwriting")),
      textured("cork", {0.9, 0.9, 0.9}, "cork", {0.4, 0.4}),
      picture("ruler"),
      picture("checker"),
      plain("grey_plastic", {0.18, 0.18, 0.19}),
      textured("crate", {0.95, 0.95, 0.95}, "crate", {1, 1}, kClamped),
      textured("ball", {0.95, 0.95, 0.95}, "ball", {1, 1}),
  };
}

std::vector<Material> visitor_materials() {
  return {
      textured("tartan", {0.95, 0.95, 0.95}, "tartan", {0.36, 0.36}),
      textured("trousers", {0.95, 0.95, 0.95}, "trousers", {0.4, 0.4}),
      textured("skin", {0.62, 0.36, 0.25}, "plaster", {0.4, 0.4}, kMirrored),
      textured("hair", {0.11, 0.07, 0.045}, "carpet", {0.12, 0.12}),
  };
}

Material shiny(Material material, double metallic, double roughness) {
  material.metallic = metallic;
  material.roughness = roughness;
  return material;
}

std::vector<Material> kitchen_materials() {
  Material glass = two_sided(shiny(plain("window_glass", {0.97, 0.985, 0.975}), 0, 0));
  glass.transmission = 1;
  return {
      glass,
      shiny(plain("mirror", {0.92, 0.92, 0.91}), 1, 0),
      shiny(plain("polished_steel", {0.63, 0.63, 0.62}), 1, 0.08),
      shiny(plain("brushed_steel", {0.6, 0.6, 0.6}), 1, 0.35),
      shiny(plain("black_glass", {0.015, 0.015, 0.017}), 0, 0.05),
      glowing(plain("light_panel", {0.8, 0.8, 0.8}), {13, 12.4, 11.2}),
  };
}

void extend(std::vector<Material>& all, const std::vector<Material>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Material> materials() {
  std::vector<Material> all = building_materials();
  extend(all, soft_materials());
  extend(all, small_materials());
  extend(all, picture_materials());
  extend(all, test_materials());
  extend(all, visitor_materials());
  extend(all, kitchen_materials());
  return all;
}

std::vector<NamedImage> images() {
  return {
      {"floor_planks", floor_planks_texture},
      {"brick", brick_texture},
      {"plaster", plaster_texture},
      {"wallpaper", wallpaper_texture},
      {"tiles", tiles_texture},
      {"wood", wood_texture},
      {"marble", marble_texture},
      {"fabric", fabric_texture},
      {"rug", rug_texture},
      {"carpet", carpet_texture},
      {"leaf", leaf_texture},
      {"cardboard", cardboard_texture},
      {"label", label_texture},
      {"book_spines", book_spines_texture},
      {"shapes_poster", shapes_poster_texture},
      {"ridges_poster", ridges_poster_texture},
      {"painting", painting_texture},
      {"map", map_texture},
      {"clock", clock_texture},
      {"screen", screen_texture},
      {"view", view_texture},
      {"mosaic", mosaic_texture},
      {"mosaic_box", mosaic_box_texture},
      {"linoleum", linoleum_texture},
      {"ceiling_panels", ceiling_panels_texture},
      {"exit_sign", exit_sign_texture},
      {"page", page_texture},
      {"handwriting", handwriting_texture},
      {"cork", cork_texture},
      {"ruler", ruler_texture},
      {"checker", checker_texture},
      {"crate", crate_texture},
      {"ball", ball_texture},
      {"tartan", tartan_texture},
      {"trousers", trousers_texture},
  };
}

}  // namespace scenes
