#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/shading/scatter.h"
#include "synth/shading/shading.h"
#include "tests/support/quads.h"
#include "tests/support/textures.h"

namespace synth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kPi = std::numbers::pi;
const RenderOptions kDirectOnly{.samples = 1, .ambient = 0};
const cv::Point kCentre(32, 24);

void expect_color(const cv::Vec3f& actual, const cv::Vec3f& expected, double tolerance = 1e-5) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(actual[i], expected[i], tolerance) << "channel " << i;
  }
}

TEST(Alpha, AMaskShowsWhatIsBehindItBelowItsCutoff) {
  const RenderedFrame open = render(red_before_green(AlphaMode::mask, 0.49F), {});
  EXPECT_EQ(open.depth(kCentre), 2);
  expect_color(open.radiance(kCentre), {0, 1, 0});
  const RenderedFrame closed = render(red_before_green(AlphaMode::mask, 0.5F), {});
  EXPECT_EQ(closed.depth(kCentre), 1);
  expect_color(closed.radiance(kCentre), {1, 0, 0});
}

TEST(Alpha, OfAnOpaqueMaterialMeansNothing) {
  const RenderedFrame frame = render(red_before_green(AlphaMode::opaque, 0), {});
  EXPECT_EQ(frame.depth(kCentre), 1);
  expect_color(frame.radiance(kCentre), {1, 0, 0});
}

TEST(Alpha, BlendedSurfacesMixAndDepthIsThatOfTheFirstAtLeastHalfThere) {
  const RenderedFrame thin = render(red_before_green(AlphaMode::blend, 0.25F), {});
  EXPECT_EQ(thin.depth(kCentre), 2);
  expect_color(thin.radiance(kCentre), {0.25F, 0.75F, 0});
  const RenderedFrame thick = render(red_before_green(AlphaMode::blend, 0.75F), {});
  EXPECT_EQ(thick.depth(kCentre), 1);
  expect_color(thick.radiance(kCentre), {0.75F, 0.25F, 0});
}

TEST(Alpha, BlendedLayersMixOnPathsToo) {
  const RenderedFrame frame =
      render(red_before_green(AlphaMode::blend, 0.25F), {.mode = RenderMode::path, .samples = 256});
  expect_color(frame.radiance(kCentre), {0.25F, 0.75F, 0}, 0.02);
}

TEST(Alpha, WhatIsMaskedAwayCastsNoShadow) {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({1, 1, 1}));
  Material veil = diffuse({1, 1, 1});
  veil.alpha_mode = AlphaMode::mask;
  veil.base_color.w() = 0.2F;
  add(scene, quad({-4, -4, -1}, {8, 0, 0}, {0, 8, 0}), veil);
  scene.lights.push_back(point_light({0, 0, -2}, {16, 16, 16}));
  expect_color(render(scene, kDirectOnly).radiance(kCentre),
               cv::Vec3f::all(static_cast<float>(1 / kPi)));
}

/// A lamp 2 m before a white wall, seen along the axis.
Scene lit_wall(const Light& light) {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({1, 1, 1}));
  scene.lights.push_back(light);
  return scene;
}

TEST(SpotLight, FadesBetweenItsConesAsKhrLightsPunctualSays) {
  Light spot = point_light({0, 0, 0}, {4, 4, 4});
  spot.kind = LightKind::spot;
  spot.inner_cone = 0.2;
  spot.outer_cone = 0.6;
  for (const double angle : {0.0, 0.15, 0.3, 0.5, 0.7}) {
    spot.direction = {std::sin(angle), 0, std::cos(angle)};
    const double share =
        std::clamp((std::cos(angle) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6)), 0.0, 1.0);
    expect_color(render(lit_wall(spot), kDirectOnly).radiance(kCentre),
                 cv::Vec3f::all(static_cast<float>(share * share / kPi)));
  }
}

TEST(PointLight, EndsAtItsRange) {
  Light light = point_light({0, 0, 0}, {4, 4, 4});
  for (const double range : {1.5, 2.5, 10.0}) {
    light.range = range;
    const double share = std::clamp(1 - std::pow(2 / range, 4), 0.0, 1.0);
    expect_color(render(lit_wall(light), kDirectOnly).radiance(kCentre),
                 cv::Vec3f::all(static_cast<float>(share / kPi)));
  }
}

TEST(NormalMap, TurnsTheNormalAlongTheTexturesAxes) {
  constexpr double kCode = 0.02;  // what 8 bits and the axes' rounding leave
  for (const auto& [texel, to_light] :
       {std::pair(cv::Vec4b(204, 128, 230, 255), Vector3d(-0.6, 0, -0.8)),
        std::pair(cv::Vec4b(128, 204, 230, 255), Vector3d(0, -0.6, -0.8))}) {
    Scene scene;
    Material material = diffuse({1, 1, 1});
    material.normal_texture = plain_texture(scene, texel);
    add(scene, quad({4, -4, 2}, {-8, 0, 0}, {0, 8, 0}), material);  // its front; u goes left
    Light sun;
    sun.kind = LightKind::directional;
    sun.direction = -to_light;
    sun.intensity.setConstant(static_cast<float>(kPi));
    scene.lights.push_back(sun);
    expect_color(render(scene, kDirectOnly).radiance(kCentre), cv::Vec3f::all(1), kCode);
  }
}

TEST(Occlusion, DimsTheAmbientLightByItsStrength) {
  Scene scene;
  Material material = diffuse({1, 1, 1});
  add(scene, square_at(2, 4), material);
  scene.lights.push_back(point_light({0, 0, 9}, {1, 1, 1}));  // behind: ambient light alone
  const float open = render(scene, {}).radiance(kCentre)[0];
  scene.materials[0].occlusion_texture = plain_texture(scene, {51, 0, 0, 255});
  scene.materials[0].occlusion_strength = 0.5F;
  EXPECT_NEAR(render(scene, {}).radiance(kCentre)[0], 0.6F * open, 1e-5F * open);
}

TEST(TextureCoordinates, OfTheSecondSetAreUsedWhereAskedFor) {
  Scene scene;
  Material material = unlit({1, 1, 1});
  material.base_color_texture = plain_texture(scene, {51, 102, 255, 255}, 1);
  Mesh mesh = square_at(2, 4);
  mesh.texcoords[1] = mesh.texcoords[0];
  mesh.texcoords[0].clear();
  add(scene, mesh, material);
  expect_color(render(scene, {}).radiance(kCentre), {0.2F, 0.4F, 1});
}

SurfacePoint shiny_point(float roughness, float metallic, float specular) {
  SurfacePoint point;
  point.position.setZero();
  point.normal = point.face_normal = Vector3f::UnitZ();
  point.to_viewer = Vector3f(0.6F, 0, 0.8F);
  point.base_color = Vector3f(0.9F, 0.5F, 0.1F);
  point.emission.setZero();
  point.roughness = roughness;
  point.metallic = metallic;
  point.specular = specular;
  return point;
}

TEST(Reflectance, StraightOnIsTheClosedForm) {
  SurfacePoint point = shiny_point(0.5F, 0, 1);
  point.to_viewer = Vector3f::UnitZ();
  const double highlight = 0.04 / (kPi * std::pow(0.25, 2)) * 0.25;
  const Vector3f f = reflectance(point, 3 * Vector3f::UnitZ());
  EXPECT_NEAR(f.x(), 0.96 * 0.9 / kPi + highlight, 1e-5);
  point.metallic = 1;
  EXPECT_NEAR(reflectance(point, Vector3f::UnitZ()).y(), 0.5 * highlight / 0.04, 1e-5);
}

TEST(Reflectance, OfAColouredDielectricTakesFromBelowWhatItsStrongestColourReflects) {
  SurfacePoint point = shiny_point(0.5F, 0, 0.5F);
  point.to_viewer = Vector3f::UnitZ();
  point.normal_reflectance = {0.25F, 1, 0};
  const double per_share = 0.5 / (kPi * std::pow(0.25, 2)) * 0.25;
  const Vector3f f = reflectance(point, Vector3f::UnitZ());
  EXPECT_NEAR(f.x(), 0.5 * 0.9 / kPi + 0.25 * per_share, 1e-5);
  EXPECT_NEAR(f.y(), 0.5 * 0.5 / kPi + per_share, 1e-5);
  EXPECT_NEAR(f.z(), 0.5 * 0.1 / kPi, 1e-5);
}

TEST(Reflectance, IsTheSameBothWaysAndLambertsWithoutHighlight) {
  const Vector3f light = Vector3f(-0.3F, 0.5F, 0.7F).normalized();
  SurfacePoint point = shiny_point(0.4F, 0.3F, 1);
  const Vector3f there = reflectance(point, light);
  const Vector3f viewer = point.to_viewer;
  point.to_viewer = light;
  EXPECT_TRUE(reflectance(point, viewer).isApprox(there, 1e-5F));
  const SurfacePoint dull = shiny_point(0.4F, 0, 0);
  EXPECT_TRUE(reflectance(dull, light).isApprox(dull.base_color / static_cast<float>(kPi), 1e-6F));
}

/// Light from all sides that comes back, by a sum over the hemisphere.
Vector3f albedo_by_quadrature(const SurfacePoint& point) {
  constexpr int kSteps = 400;
  Vector3f sum = Vector3f::Zero();
  for (int i = 0; i < kSteps; ++i) {
    for (int k = 0; k < kSteps; ++k) {
      const double z = (i + 0.5) / kSteps;
      const double angle = 2 * kPi * (k + 0.5) / kSteps;
      const double sine = std::sqrt(1 - z * z);
      const Vector3f light =
          Vector3d(sine * std::cos(angle), sine * std::sin(angle), z).cast<float>();
      sum += reflectance(point, light) * static_cast<float>(z * 2 * kPi / (kSteps * kSteps));
    }
  }
  return sum;
}

TEST(Scatter, SendsBackOnAverageWhatTheReflectanceSumsTo) {
  for (const SurfacePoint& point :
       {shiny_point(0.5F, 0, 1), shiny_point(0.4F, 1, 1), shiny_point(1, 0.5F, 1)}) {
    constexpr int kRoot = 200;
    Vector3f sum = Vector3f::Zero();
    for (int i = 0; i < kRoot * kRoot; ++i) {
      const auto lobe = static_cast<float>(i * 0.6180339887 - std::floor(i * 0.6180339887));
      const Vector2f square((static_cast<float>(i / kRoot) + 0.5F) / kRoot,
                            (static_cast<float>(i % kRoot) + 0.5F) / kRoot);
      sum += scatter(point, lobe, square).weight;
    }
    const Vector3f expected = albedo_by_quadrature(point);
    EXPECT_TRUE((sum / (kRoot * kRoot)).isApprox(expected, 0.01F))
        << sum.transpose() / (kRoot * kRoot) << " instead of " << expected.transpose();
    EXPECT_LE(expected.maxCoeff(), 1);
  }
}

/// A white mirror sends back all light; single precision must not add to it at grazing angles.
TEST(Scatter, OfAWhiteMirrorSendsBackWhatArrives) {
  for (const float roughness : {0.0F, 0.03F, 0.05F}) {
    for (const double degrees : {0.0, 45.0, 70.0, 80.0}) {
      SurfacePoint point = shiny_point(roughness, 1, 1);
      point.base_color.setOnes();
      const double angle = degrees * kPi / 180;
      point.to_viewer = Vector3d(std::sin(angle), 0, std::cos(angle)).cast<float>();
      constexpr int kRoot = 100;
      double sum = 0;
      for (int i = 0; i < kRoot * kRoot; ++i) {
        const Vector2f square((static_cast<float>(i / kRoot) + 0.5F) / kRoot,
                              (static_cast<float>(i % kRoot) + 0.5F) / kRoot);
        const auto lobe = static_cast<float>(i * 0.6180339887 - std::floor(i * 0.6180339887));
        sum += scatter(point, lobe, square).weight.x();
      }
      EXPECT_NEAR(sum / (kRoot * kRoot), 1, 2e-3) << roughness << " " << degrees;
    }
  }
}

TEST(Scatter, DrawsDirectionsWithTheDensityThatItStates) {
  for (const SurfacePoint& point :
       {shiny_point(0.5F, 0, 1), shiny_point(0.4F, 1, 1), shiny_point(1, 0.5F, 1)}) {
    // Means of functions over drawn directions against integrals of these times the density.
    constexpr int kSteps = 400;
    constexpr int kDraws = 200 * 200;
    Vector3d drawn = Vector3d::Zero();
    Vector3d integrated = Vector3d::Zero();
    const auto moments = [](const Vector3f& direction) {
      return Vector3d(1, direction.x(), direction.z() * direction.z());
    };
    for (int i = 0; i < kDraws; ++i) {
      const auto lobe = static_cast<float>(i * 0.6180339887 - std::floor(i * 0.6180339887));
      const Vector2f square((static_cast<float>(i / 200) + 0.5F) / 200,
                            (static_cast<float>(i % 200) + 0.5F) / 200);
      const Scattered scattered = scatter(point, lobe, square);
      drawn += scattered.density > 0 ? Vector3d(moments(scattered.direction) / kDraws)
                                     : Vector3d::Zero();
    }
    for (int i = 0; i < kSteps; ++i) {
      for (int k = 0; k < kSteps; ++k) {
        const double z = (i + 0.5) / kSteps;
        const double angle = 2 * kPi * (k + 0.5) / kSteps;
        const double sine = std::sqrt(1 - z * z);
        const Vector3f direction =
            Vector3d(sine * std::cos(angle), sine * std::sin(angle), z).cast<float>();
        integrated +=
            moments(direction) * scatter_density(point, direction) * (2 * kPi / (kSteps * kSteps));
      }
    }
    EXPECT_TRUE(drawn.isApprox(integrated, 2e-3))
        << drawn.transpose() << " instead of " << integrated.transpose();
  }
}

}  // namespace
}  // namespace synth
