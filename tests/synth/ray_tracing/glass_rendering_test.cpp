#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/shading/glass.h"
#include "tests/support/balls.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

const cv::Point kMiddle(32, 24);

/// Glass that absorbs nothing.
Material glass(bool is_solid, float roughness = 0) {
  Material material = diffuse({1, 1, 1});
  material.specular = 1;
  material.roughness = roughness;
  material.layers.transmission = 1;
  material.layers.is_solid = is_solid;
  return material;
}

/// Glass whose surface reflects nothing, so that every ray goes through.
Material without_reflection(Material material) {
  material.specular = 0;
  return material;
}

/// Paths of one sample per pixel, at the pixel's centre.
RenderOptions by_paths(int samples, int bounces = 8) {
  return {.mode = RenderMode::path, .samples = samples, .ambient = 0, .bounces = bounces};
}

TEST(Glass, ABallThatAbsorbsNothingCannotBeSeenBeforeAWhiteSky) {
  for (const bool is_solid : {false, true}) {
    const RenderedFrame frame = render(ball_in_white(glass(is_solid)), by_paths(64, 64));
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(frame.radiance, mean, deviation);
    EXPECT_NEAR(mean[1], 1, 1e-3) << is_solid;
    EXPECT_LT(deviation[1], 5e-3) << is_solid;
  }
}

TEST(Glass, ThatIsRoughKeepsAlmostAllLight) {
  for (const bool is_solid : {false, true}) {
    const RenderedFrame frame = render(ball_in_white(glass(is_solid, 0.3F)), by_paths(64, 16));
    const cv::Rect inside(kMiddle - cv::Point(5, 5), cv::Size(11, 11));
    const double mean = cv::mean(frame.radiance(inside))[1];
    EXPECT_GT(mean, 0.97) << is_solid;
    EXPECT_LE(mean, 1.001) << is_solid;
  }
}

/// A wall 4 m before the camera whose unlit red channel grows from 0 at x = -8 m to 1 at 8 m.
void add_ramp(Scene& scene) {
  Mesh wall = square_at(4, 8);
  wall.colors = {{0, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {0, 1, 1, 1}};
  add(scene, wall, unlit({1, 1, 1}));
}

/// Both faces of a slab from 1 m to 1 m + `thickness`, with their fronts outside.
Scene slab_before_ramp(const Material& material, float thickness) {
  Scene scene;
  add(scene, quad({9, -9, 1}, {-18, 0, 0}, {0, 18, 0}), material);
  add(scene, quad({-9, -9, 1 + thickness}, {18, 0, 0}, {0, 18, 0}), material);
  add_ramp(scene);
  return scene;
}

TEST(Glass, ASlabShiftsWhatIsBehindItByTheClosedForm) {
  constexpr double kThickness = 0.5;
  constexpr double kIor = 1.4;
  Material material = without_reflection(glass(true));
  material.ior = static_cast<float>(kIor);
  const RenderedFrame frame =
      render(slab_before_ramp(material, static_cast<float>(kThickness)), by_paths(1));
  const vo::PinholeCamera camera = wide_camera();
  for (const int u : {0, 10, 32, 50, 64}) {
    const double tangent = camera.unproject(Vector2d(u, 24), 1).x();
    const double sine = tangent / std::sqrt(1 + tangent * tangent) / kIor;
    const double inside = sine / std::sqrt(1 - sine * sine);
    const double x = tangent * (4 - kThickness) + inside * kThickness;
    EXPECT_NEAR(frame.radiance(24, u)[0], (x + 8) / 16, 2e-5) << "column " << u;
  }
}

TEST(Glass, ASlabAbsorbsByTheLengthOfTheRefractedRay) {
  constexpr double kThickness = 0.5;
  Material material = without_reflection(glass(true));
  material.layers.attenuation_color = {0.5F, 0.25F, 1};
  material.layers.attenuation_distance = 0.3F;
  const RenderedFrame frame =
      render(slab_before_ramp(material, static_cast<float>(kThickness)), by_paths(1));
  const vo::PinholeCamera camera = wide_camera();
  for (const int u : {0, 20, 32, 64}) {
    const double tangent = camera.unproject(Vector2d(u, 24), 1).x();
    const double sine = tangent / std::sqrt(1 + tangent * tangent) / 1.5;
    const double length = kThickness / std::sqrt(1 - sine * sine);
    EXPECT_NEAR(frame.radiance(24, u)[1], std::exp(std::log(0.25) * length / 0.3), 1e-5)
        << "column " << u;
    EXPECT_NEAR(frame.radiance(24, u)[2], 1, 1e-6) << "column " << u;
  }
}

TEST(Glass, AThinWallTintsAndDoesNotShift) {
  Material tinted = without_reflection(glass(false));
  tinted.base_color = {0.5F, 0.25F, 1, 1};
  Scene with_pane;
  add(with_pane, square_at(1, 9), tinted);
  add_ramp(with_pane);
  Scene without;
  add_ramp(without);
  const cv::Mat_<cv::Vec3f> tinted_image = render(with_pane, by_paths(1)).radiance;
  const cv::Mat_<cv::Vec3f> image = render(without, by_paths(1)).radiance;
  for (const int u : {0, 32, 64}) {
    EXPECT_NEAR(tinted_image(24, u)[0], 0.5 * image(24, u)[0], 1e-6);
    EXPECT_NEAR(tinted_image(24, u)[1], 0.25, 1e-6);
  }
}

TEST(Glass, AThinWallReflectsByFresnelsShare) {
  Scene scene;
  add(scene, square_at(1, 9), glass(false));
  add(scene, square_at(4, 40), unlit({0, 0, 0}));
  surround_with_white(scene);
  EXPECT_NEAR(render(scene, by_paths(4096)).radiance(kMiddle)[1], 0.04, 5e-4);
}

/// A wall 2 m before the camera and a lamp 1 m behind it, of 6 m by 6 m.
Scene lamp_lit_wall() {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({0.5F, 0.5F, 0.5F}));
  Material lamp = diffuse({0, 0, 0});
  lamp.emission.setConstant(4);
  add(scene, square_at(-1, 3), lamp);
  scene.lights.push_back(point_light({0, 0, 0}, {0, 0, 0}));
  return scene;
}

TEST(Glass, LightOfALampReachesThroughItWithoutLoss) {
  const double open = cv::mean(render(lamp_lit_wall(), by_paths(256, 1)).radiance)[1];
  Scene glazed = lamp_lit_wall();
  add(glazed, square_at(-0.5F, 9), without_reflection(glass(false)));
  EXPECT_NEAR(cv::mean(render(glazed, by_paths(256, 1)).radiance)[1], open, 0.01 * open);
  Scene blocked = lamp_lit_wall();  // by a slab, which does not turn light from its direction
  add(blocked, quad({9, -9, -0.7F}, {-18, 0, 0}, {0, 18, 0}), without_reflection(glass(true)));
  add(blocked, quad({-9, -9, -0.7F + 1e-3F}, {18, 0, 0}, {0, 18, 0}),
      without_reflection(glass(true)));
  EXPECT_NEAR(cv::mean(render(blocked, by_paths(256, 1)).radiance)[1], open, 0.01 * open);
}

/// A wall 2 m before the camera, lit from 1 m behind it by a lamp without size.
Scene wall_and_lamp() {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({0.5F, 0.5F, 0.5F}));
  scene.lights.push_back(point_light({0, 0, -1}, {9, 9, 9}));
  return scene;
}

TEST(Glass, LampsWithoutSizeLightThroughThinWallsByFresnelsShareAndTint) {
  const cv::Mat_<cv::Vec3f> open = render(wall_and_lamp(), by_paths(1, 0)).radiance;
  ASSERT_GT(open(kMiddle)[1], 0.01);
  Material tinted = glass(false);
  tinted.base_color = {0.5F, 0.25F, 1, 1};
  Scene glazed = wall_and_lamp();
  add(glazed, square_at(-0.5F, 9), tinted);
  add(glazed, square_at(-0.6F, 9), tinted);
  const cv::Mat_<cv::Vec3f> image = render(glazed, by_paths(1, 0)).radiance;
  const vo::PinholeCamera camera = wide_camera();
  for (const cv::Point& pixel : {cv::Point(0, 24), cv::Point(20, 3), kMiddle, cv::Point(63, 47)}) {
    const Vector3d place = camera.unproject(Vector2d(pixel.x, pixel.y), 2);
    const double cosine = 3 / (place - Vector3d(0, 0, -1)).norm();
    const double passed = 1 - fresnel_reflectance(static_cast<float>(cosine), 1.5F);
    EXPECT_NEAR(image(pixel)[2], passed * passed * open(pixel)[2], 1e-6) << pixel;
    EXPECT_NEAR(image(pixel)[1], 0.0625 * passed * passed * open(pixel)[1], 1e-6) << pixel;
    EXPECT_NEAR(image(pixel)[0], 0.25 * passed * passed * open(pixel)[0], 1e-6) << pixel;
  }
}

TEST(Glass, LampsWithoutSizeLightThroughNoWallThatIsRoughOrSolidOrBehindSomethingOpaque) {
  for (const Material& material : {glass(false, 0.3F), glass(true)}) {
    Scene scene = wall_and_lamp();
    add(scene, square_at(-0.5F, 9), material);
    EXPECT_EQ(cv::norm(render(scene, by_paths(1, 0)).radiance, cv::NORM_INF), 0);
  }
  Scene scene = wall_and_lamp();
  add(scene, square_at(-0.5F, 9), glass(false));
  add(scene, square_at(-0.6F, 9), diffuse({1, 1, 1}));
  EXPECT_EQ(cv::norm(render(scene, by_paths(1, 0)).radiance, cv::NORM_INF), 0);
}

TEST(Glass, CastsShadowsInDirectLightWhateverAlphaItsOpaqueMaterialHas) {
  Material pane = glass(false);
  pane.base_color.w() = 0.1F;
  Scene scene = wall_and_lamp();
  add(scene, square_at(-0.5F, 9), pane);
  EXPECT_EQ(
      cv::norm(render(scene, {.mode = RenderMode::direct, .ambient = 0}).radiance, cv::NORM_INF),
      0);
}

TEST(Glass, DepthIsThatOfTheGlass) {
  EXPECT_EQ(render(slab_before_ramp(glass(true), 0.5F), by_paths(1)).depth(kMiddle), 1);
}

TEST(Glass, IsOpaqueInDirectLight) {
  Scene clear = slab_before_ramp(glass(true), 0.5F);
  Scene plain = clear;
  plain.materials[0].layers = plain.materials[1].layers = {};
  for (const RenderMode mode : {RenderMode::direct, RenderMode::unlit}) {
    EXPECT_EQ(cv::norm(render(clear, {.mode = mode}).radiance,
                       render(plain, {.mode = mode}).radiance, cv::NORM_INF),
              0);
  }
}

TEST(Glass, IsNotedWhereAModeLeavesItOut) {
  Scene scene = slab_before_ramp(glass(true), 0.5F);
  scene.materials[0].name = "window";
  EXPECT_TRUE(notes_on_materials(scene, by_paths(1)).empty());
  EXPECT_TRUE(notes_on_materials(scene, {.mode = RenderMode::depth}).empty());
  const std::vector<std::string> notes = notes_on_materials(scene, {.mode = RenderMode::direct});
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("\"window\""), std::string::npos);
  RenderOptions rasterized = by_paths(1);
  rasterized.kind = RendererKind::rasterizer;
  EXPECT_EQ(notes_on_materials(scene, rasterized), notes);
  EXPECT_TRUE(notes_on_materials(ball_in_white(diffuse({1, 1, 1})), {}).empty());
}

TEST(Coat, OnBlackReflectsTheSkyByFresnelsShareAndHidesWhatShines) {
  Material coated = diffuse({0, 0, 0});
  coated.emission.setConstant(10);
  coated.layers.clearcoat = 0.5F;
  Scene scene;
  add(scene, square_at(1, 9), coated);
  surround_with_white(scene);
  const double reflected = 0.5 * 0.04;
  EXPECT_NEAR(render(scene, by_paths(1024)).radiance(kMiddle)[1], 10 * (1 - reflected) + reflected,
              1e-3);
}

TEST(Coat, WithoutStrengthChangesNothing) {
  Material material = diffuse({0.5F, 0.3F, 0.1F});
  material.specular = 1;
  material.roughness = 0.4F;
  const cv::Mat_<cv::Vec3f> plain = render(ball_in_white(material), by_paths(4)).radiance;
  material.layers.clearcoat_roughness = 0.5F;
  EXPECT_EQ(cv::norm(plain, render(ball_in_white(material), by_paths(4)).radiance, cv::NORM_INF),
            0);
  material.layers.clearcoat = 1;
  EXPECT_GT(cv::norm(plain, render(ball_in_white(material), by_paths(4)).radiance, cv::NORM_INF),
            0);
}

}  // namespace
}  // namespace synth
