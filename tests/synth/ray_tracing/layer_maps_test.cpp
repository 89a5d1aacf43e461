#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/scene/scene_hash.h"
#include "tests/support/quads.h"
#include "tests/support/textures.h"

namespace synth {
namespace {

const RenderOptions kPaths{.mode = RenderMode::path, .samples = 16, .ambient = 0, .bounces = 4};

/// A glossy pane that lets through half of the light, with a coat, before a lit wall.
Scene pane_before_wall(const Material& pane, Scene scene) {
  add(scene, square_at(1, 1), pane);
  add(scene, square_at(2, 4), diffuse({0.9F, 0.5F, 0.2F}));
  scene.lights.push_back(point_light({0.5, -1, -0.5}, {3, 3, 3}));
  return scene;
}

Material coated_pane() {
  Material pane = diffuse({0.4F, 0.6F, 0.8F});
  pane.specular = 1;
  pane.roughness = 0.3F;
  pane.layers.transmission = 1;
  pane.layers.clearcoat = 1;
  pane.layers.clearcoat_roughness = 1;
  return pane;
}

/// Rendering draws equal random numbers for both, so that their pictures are equal, too.
TEST(LayerMaps, OfOneTexelRenderAsTheFactorsThatTheyMultiplyTo) {
  Scene mapped;
  const cv::Vec4b texel(102, 51, 0, 204);
  Material pane = coated_pane();
  pane.layers.transmission_texture = plain_texture(mapped, texel);
  pane.layers.clearcoat_texture = plain_texture(mapped, texel);
  pane.layers.clearcoat_roughness_texture = plain_texture(mapped, texel);
  pane.specular_texture = plain_texture(mapped, texel);
  pane.specular_color_texture = plain_texture(mapped, texel);
  Material plain = coated_pane();
  plain.layers.transmission = plain.layers.clearcoat = 102.0F / 255;
  plain.layers.clearcoat_roughness = 51.0F / 255;
  plain.specular = 204.0F / 255;
  plain.specular_color = Eigen::Vector3f(102, 51, 0) / 255;
  const cv::Mat_<cv::Vec3f> actual = render(pane_before_wall(pane, mapped), kPaths).radiance;
  const cv::Mat_<cv::Vec3f> expected = render(pane_before_wall(plain, {}), kPaths).radiance;
  EXPECT_LE(cv::norm(actual, expected, cv::NORM_INF), 1e-5);
  EXPECT_GT(
      cv::norm(actual, render(pane_before_wall(coated_pane(), {}), kPaths).radiance, cv::NORM_INF),
      0.1);
}

TEST(LayerMaps, MakeOneHalfOfAPaneGlass) {
  Scene scene;
  Material pane = diffuse({1, 0, 0});
  pane.roughness = 0;
  pane.layers.transmission = 1;
  pane.layers.transmission_texture =
      add_texels(scene, (cv::Mat_<cv::Vec4b>(1, 2) << cv::Vec4b(255, 0, 0, 0), cv::Vec4b::all(0)));
  add(scene, square_at(1, 2), pane);
  add(scene, square_at(2, 4), unlit({3, 5, 7}));
  scene.lights.push_back(point_light({0, 0, -100}, {1e-9F, 1e-9F, 1e-9F}));
  const cv::Mat_<cv::Vec3f> radiance = render(scene, kPaths).radiance;
  EXPECT_NEAR(radiance(24, 16)[0], 3, 1e-3) << "the wall behind, through red glass";
  EXPECT_NEAR(radiance(24, 16)[1], 0, 1e-6);
  EXPECT_NEAR(radiance(24, 48)[0], 0, 1e-3) << "an opaque half that nothing lights";
}

TEST(LayerMaps, ArePartOfAScenesHash) {
  Scene scene;
  Material pane = coated_pane();
  const std::string plain = content_hash(pane_before_wall(pane, scene));
  pane.layers.transmission_texture.texture = 0;
  const std::string transmission = content_hash(pane_before_wall(pane, scene));
  pane.layers.clearcoat_texture = std::exchange(pane.layers.transmission_texture, {});
  const std::string coat = content_hash(pane_before_wall(pane, scene));
  EXPECT_NE(transmission, plain);
  EXPECT_NE(coat, plain);
  EXPECT_NE(coat, transmission);
}

}  // namespace
}  // namespace synth
