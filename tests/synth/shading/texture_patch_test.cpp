#include "synth/shading/texture_patch.h"

#include <cstdint>

#include <gtest/gtest.h>

#include "synth/scene/texture.h"
#include "synth/shading/surface.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3f;

constexpr int kTexels = 256;

/// Returns a scene of a square of 1 m across the z axis, a texel of whose texture is as `red` says.
template <typename Red>
Scene square_of_texels(int columns, int rows, const Red& red) {
  cv::Mat_<cv::Vec4b> texels(rows, columns);
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      texels(v, u) = cv::Vec4b(red(u, v), 0, 0, 255);
    }
  }
  Scene scene;
  Material material = unlit({1, 1, 1});
  material.base_color_texture.texture = 0;
  scene.textures.push_back({.image = 0});
  scene.images.push_back(build_mip_levels(texels, TexelEncoding::linear));
  add(scene, square_at(0, 0.5F), material);
  return scene;
}

/// Returns the red of a place on the square, u and v of the texture, seen by a cone of this width.
float red_at(const Scene& scene, const Eigen::Vector2f& uv, const Vector3f& direction, float width,
             int anisotropy) {
  const WorldGeometry world = flatten(scene);
  const SurfaceTriangle triangle(world, 0, 0);  // its corners' uv: (0, 0), (1, 0), (1, 1)
  const Vector3f weights(1 - uv.x(), uv.x() - uv.y(), uv.y());
  return surface_color(triangle, {weights, direction, width, 0, anisotropy}).x();
}

std::uint8_t stripe(int index) {
  return index % 2 == 0 ? 255 : 0;
}

const Vector3f kAlongColumns(0, 1, 0.125F);  // 7 degrees above the square
constexpr float kTexel = 1.0F / kTexels;     // m
const Eigen::Vector2f kPlace(200.5F / kTexels, 100.5F / kTexels);

TEST(Anisotropy, SeesStripesThatRunAlongASlant) {
  const Scene scene = square_of_texels(kTexels, kTexels, [](int u, int) { return stripe(u); });
  EXPECT_NEAR(red_at(scene, kPlace, kAlongColumns, kTexel, 16), 1, 0.02);
  EXPECT_NEAR(red_at(scene, kPlace, kAlongColumns, kTexel, 1), 0.5, 0.02)
      << "all around is blurred";
}

TEST(Anisotropy, BlursStripesThatRunAcrossASlant) {
  const Scene scene = square_of_texels(kTexels, kTexels, [](int, int v) { return stripe(v); });
  EXPECT_NEAR(red_at(scene, kPlace, kAlongColumns, kTexel, 16), 0.5, 0.1);
}

/// A cone that is wide along the stripes and narrow across them sees them, and the other way not.
TEST(Anisotropy, FollowsTheSidesOfACone) {
  const Scene scene = square_of_texels(kTexels, kTexels, [](int u, int) { return stripe(u); });
  const WorldGeometry world = flatten(scene);
  const SurfaceTriangle triangle(world, 0, 0);
  const Vector3f weights(1 - kPlace.x(), kPlace.x() - kPlace.y(), kPlace.y());
  const RaySides narrow{Vector3f(0.125F, 0, 0), Vector3f(0, 1, 0)};
  const RaySides wide{Vector3f(1, 0, 0), Vector3f(0, 0.125F, 0)};
  for (const Vector3f& direction : {Vector3f(0, 0, 1), Vector3f(0, 0.6F, 0.8F)}) {
    SurfaceRay ray{weights, direction, 8 * kTexel, 0, 16, &narrow};
    EXPECT_NEAR(surface_color(triangle, ray).x(), 1, 0.02);
    ray.sides = &wide;
    EXPECT_NEAR(surface_color(triangle, ray).x(), 0.5, 0.1);
  }
}

TEST(Anisotropy, IsNoneStraightOn) {
  const Scene scene =
      square_of_texels(kTexels, kTexels, [](int u, int v) { return stripe(u / 3 + v / 5); });
  for (const float width : {0.5F * kTexel, 3 * kTexel}) {
    EXPECT_NEAR(red_at(scene, kPlace, Vector3f::UnitZ(), width, 16),
                red_at(scene, kPlace, Vector3f::UnitZ(), width, 1), 1e-3);
  }
}

/// A column of texels is as wide as four rows are high, so that a circle covers four rows.
TEST(Anisotropy, IsThatOfTheImageWhereItsTexelsAreLong) {
  const Scene scene = square_of_texels(kTexels / 4, kTexels, [](int u, int) { return stripe(u); });
  const Eigen::Vector2f middle(40.5F / (kTexels / 4), 0.3F);
  EXPECT_NEAR(red_at(scene, middle, Vector3f::UnitZ(), 4 * kTexel, 16), 1, 0.02);
  EXPECT_NEAR(red_at(scene, middle, Vector3f::UnitZ(), 4 * kTexel, 1), 0.5, 0.02);
}

TEST(Anisotropy, KeepsTheMeanOfAnEvenGradient) {
  const Scene scene = square_of_texels(
      kTexels, kTexels, [](int u, int v) { return static_cast<std::uint8_t>((u + v) / 2); });
  const double expected = (200 + 100) / 2.0 / 255;
  for (const Vector3f& direction :
       {kAlongColumns, Vector3f(1, 0, 0.2F), Vector3f(0.7F, -0.7F, 0.3F)}) {
    EXPECT_NEAR(red_at(scene, kPlace, direction, kTexel, 16), expected, 2e-3);
  }
}

TEST(Anisotropy, ReadsASingleTexelUnlessThereIsOne) {
  const Scene scene = square_of_texels(1, 1, [](int, int) { return std::uint8_t{51}; });
  EXPECT_NEAR(red_at(scene, kPlace, kAlongColumns, kTexel, 16), 0.2, 1e-6);
}

}  // namespace
}  // namespace synth
