#include "synth/shading/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kHalfTurn = std::numbers::pi;
constexpr float kRounding = 1e-6F;  // relative, of a few operations on floats
const RenderOptions kDirectLightOnly{.samples = 1, .ambient = 0};

cv::Vec3f centre_of(const RenderedFrame& frame) {
  return frame.radiance(24, 32);
}

void expect_near(const cv::Vec3f& actual, const cv::Vec3f& expected, double relative = kRounding) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(actual[i], expected[i], relative * expected[i]) << "channel " << i;
  }
}

TEST(Shading, AnUnlitSurfaceShowsItsBaseColor) {
  Scene scene;
  add(scene, square_at(1, 2), unlit({0.25F, 0.5F, 0.125F}));
  scene.lights.push_back(point_light({0, 0, 0}, {9, 9, 9}));
  EXPECT_EQ(centre_of(render(scene, {})), cv::Vec3f(0.25F, 0.5F, 0.125F));
}

TEST(Shading, VertexColorsAreInterpolatedAndMultiplyTheBaseColor) {
  Scene scene;
  Mesh mesh = square_at(1, 1);
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 1, 0, 1}};
  add(scene, mesh, unlit({0.5F, 0.5F, 0.5F}));
  expect_near(centre_of(render(scene, {.samples = 1})), {0.25F, 0, 0.25F});
}

TEST(Shading, APointLightOnADiffuseSurfaceHasTheClosedForm) {
  const Vector3d light(0.4, -0.7, 0.5);
  Scene scene;
  add(scene, square_at(2, 4), diffuse({0.8F, 0.4F, 0.2F}));
  scene.lights.push_back(point_light(light, {10, 20, 30}));
  const vo::PinholeCamera camera = wide_camera();
  const RenderedFrame frame = render(scene, kDirectLightOnly);
  for (const Vector2d& pixel : {Vector2d(32, 24), Vector2d(0, 0), Vector2d(64, 5)}) {
    const Vector3d to_light = light - camera.unproject(pixel, 2);
    const double cosine = -to_light.z() / to_light.norm();
    const auto scale = static_cast<float>(cosine / to_light.squaredNorm() / kHalfTurn);
    const cv::Vec3f expected(8 * scale, 8 * scale, 6 * scale);
    expect_near(frame.radiance(cv::Point(pixel.cast<int>().x(), pixel.cast<int>().y())), expected,
                1e-5);
  }
}

Light sun(const Vector3d& direction, float lux) {
  Light light;
  light.kind = LightKind::directional;
  light.direction = direction.normalized();
  light.intensity.setConstant(lux);
  return light;
}

TEST(Shading, ADirectionalLightFollowsTheCosineOfItsSlant) {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({1, 1, 1}));
  scene.lights.push_back(sun({3, 0, 4}, 5));
  const auto expected = static_cast<float>(5 * 0.8 / kHalfTurn);
  expect_near(centre_of(render(scene, kDirectLightOnly)), cv::Vec3f::all(expected));
}

TEST(Shading, LightFromBehindDoesNotShineThrough) {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({1, 1, 1}));
  scene.lights.push_back(point_light({0, 0, 3}, {10, 10, 10}));
  scene.lights.push_back(sun({0, 0, -1}, 5));
  EXPECT_EQ(centre_of(render(scene, kDirectLightOnly)), cv::Vec3f::all(0));
}

/// A square across the axis, lit along it, with the same normal at all its vertices.
Scene square_with_normal(const Vector3f& normal) {
  Scene scene;
  Mesh mesh = square_at(2, 4);
  mesh.normals.assign(4, normal);
  add(scene, mesh, diffuse({1, 1, 1}));
  scene.lights.push_back(sun({0, 0, 1}, static_cast<float>(kHalfTurn)));
  return scene;
}

TEST(Shading, VertexNormalsGiveTheSlantOnEitherSide) {
  for (const float side : {-1.0F, 1.0F}) {
    const Scene scene = square_with_normal(side * Vector3f(0.6F, 0, -0.8F));
    expect_near(centre_of(render(scene, kDirectLightOnly)), cv::Vec3f::all(0.8F));
  }
}

TEST(Shading, NormalsOfNoLengthAreReplacedByTheTriangles) {
  const Scene scene = square_with_normal(Vector3f::Zero());
  expect_near(centre_of(render(scene, kDirectLightOnly)), cv::Vec3f::all(1));
}

TEST(Shading, NormalsTurnWithAStretchedSurface) {
  Scene scene = square_with_normal(Vector3f(0.6F, 0, -0.8F));
  scene.instances[0].T_world_mesh = Eigen::Scaling(Vector3d(0.5, 1, 1));
  const auto expected = static_cast<float>(0.8 / std::hypot(0.6 / 0.5, 0.8));
  expect_near(centre_of(render(scene, kDirectLightOnly)), cv::Vec3f::all(expected));
}

TEST(Shading, EmissionAddsToWhatIsReflected) {
  Scene scene;
  Material lamp = diffuse({1, 1, 1});
  lamp.emission = {0.1F, 0.2F, 0.3F};
  add(scene, square_at(2, 4), lamp);
  scene.lights.push_back(sun({0, 0, 1}, static_cast<float>(kHalfTurn)));
  expect_near(centre_of(render(scene, kDirectLightOnly)), {1.1F, 1.2F, 1.3F});
}

TEST(Shading, AmbientLightIsAShareOfTheFluxOverTheBoxesSurface) {
  Scene scene;
  add(scene, quad({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), diffuse({1, 1, 1}));
  add(scene, quad({-1, -1, 2}, {0, 0, 2}, {0, 2, 0}), diffuse({1, 1, 1}));
  add(scene, square_at(99, 99), unlit({1, 1, 1}));            // not lit, hence not in the box
  scene.lights.push_back(point_light({0, 0, 3}, {6, 6, 6}));  // inside, behind what is seen
  scene.lights.push_back(sun({0, 0, -1}, 4));                 // likewise
  const double mean = 4 * kHalfTurn * 6 / 24 + 4.0 / 4;
  const auto expected = static_cast<float>(0.3 * mean / kHalfTurn);
  expect_near(centre_of(render(scene, {.samples = 1, .ambient = 0.3})), cv::Vec3f::all(expected));
}

TEST(Shading, APointLightFarAwayCountsAsTheSunItIs) {
  Scene far;
  add(far, quad({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), diffuse({1, 1, 1}));
  add(far, quad({-1, -1, 2}, {0, 0, 2}, {0, 2, 0}), diffuse({1, 1, 1}));
  Scene sunny = far;
  far.lights.push_back(point_light({0, 0, 3 + 1e3}, {1e6F, 1e6F, 1e6F}));
  sunny.lights.push_back(sun({0, 0, -1}, 1));
  constexpr double kParallel = 1e-5;  // relative, for rays that are not quite parallel
  expect_near(centre_of(render(far, {})), centre_of(render(sunny, {})), kParallel);
}

TEST(Shading, WithoutLightsASurfaceThatFacesTheSkyShowsItsBaseColor) {
  const Vector3f axis = Vector3f(0.3F, 1, 0.5F).normalized();
  Scene scene;
  Mesh mesh = square_at(2, 4);
  mesh.normals.assign(4, axis);
  add(scene, mesh, diffuse({0.5F, 0.25F, 1}));
  scene.meshes[0].normals.assign(4, -axis);  // turned to the viewer, who is below: away from it
  const float share = 0.3F;
  const float darkest = share / 2 / (1 + share / 2);
  const RenderedFrame frame = render(scene, {.samples = 1, .ambient = share});
  expect_near(centre_of(frame), {0.5F * darkest, 0.25F * darkest, darkest}, 1e-5);
  const vo::SE3 T_world_camera(Eigen::Quaterniond(0, 1, 0, 0), {0, 0, 4});  // from the other side
  const RenderedFrame bright = render(scene, {.samples = 1}, wide_camera(), T_world_camera);
  expect_near(centre_of(bright), {0.5F, 0.25F, 1});
}

TextureImage four_texels() {
  cv::Mat_<cv::Vec4b> image(2, 2);
  image << cv::Vec4b(255, 0, 0, 255), cv::Vec4b(0, 255, 0, 255), cv::Vec4b(0, 0, 255, 255),
      cv::Vec4b(255, 255, 255, 255);
  return {.levels = {image, cv::Mat_<cv::Vec4b>(1, 1, cv::Vec4b(9, 9, 9, 255))}};
}

Scene textured_square(const TextureImage& image) {
  Scene scene;
  Material material = unlit({1, 1, 1});
  material.base_color_texture.texture = 0;
  add(scene, square_at(1, 0.5F), material);
  scene.textures.push_back({.image = 0,
                            .magnification = TexelFilter::nearest,
                            .minification = TexelFilter::nearest,
                            .mip = MipFilter::nearest});
  scene.images.push_back(image);
  return scene;
}

TEST(Shading, TheFirstTexelIsAtTheTopLeft) {
  const RenderedFrame frame = render(textured_square(four_texels()), {.samples = 1});
  EXPECT_EQ(frame.radiance(20, 28), cv::Vec3f(1, 0, 0));
  EXPECT_EQ(frame.radiance(20, 36), cv::Vec3f(0, 1, 0));
  EXPECT_EQ(frame.radiance(28, 28), cv::Vec3f(0, 0, 1));
  EXPECT_EQ(frame.radiance(28, 36), cv::Vec3f(1, 1, 1));
}

TEST(Shading, ATextureIsReadAtTheLevelWhoseTexelsAreAsWideAsTheSamples) {
  TextureImage image;  // level k is 64 >> k texels wide and shows the code k + 1
  for (int level = 0; level <= 6; ++level) {
    const auto code = static_cast<uchar>(level + 1);
    image.levels.emplace_back(64 >> level, 64 >> level, cv::Vec4b(code, code, code, 255));
  }
  Scene scene = textured_square(image);
  const float code_one = 1 / 255.0F / 12.92F;  // sRGB is linear for the darkest codes
  for (const double focal_px : {64.0, 32.0, 16.0}) {
    vo::PinholeCamera camera = wide_camera();
    camera.fx = camera.fy = focal_px;
    const double level = std::log2(64 / focal_px);
    const auto expected = static_cast<float>(code_one * (level + 1));
    expect_near(centre_of(render(scene, {.samples = 1}, camera)), cv::Vec3f::all(expected));
    const double sharper = std::max(0.0, level - 1);  // a grid of 2 x 2 halves the footprint
    expect_near(centre_of(render(scene, {.samples = 4}, camera)),
                cv::Vec3f::all(static_cast<float>(code_one * (sharper + 1))));
  }
}

}  // namespace
}  // namespace synth
