#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/rendering/infrared.h"
#include "tests/support/quads.h"
#include "tests/support/same_pixels.h"

namespace synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using support::have_same_pixels;

constexpr double kFlatAngle = std::numbers::pi;

/// A projector to the right of the camera and turned towards its axis.
Projector beside_camera(cv::Mat_<float> pattern) {
  return {.name = "dots",
          .T_camera_projector = {Eigen::Quaterniond(
                                     Eigen::AngleAxisd(-0.1, Vector3d(0.2, 1, 0.1).normalized())),
                                 Vector3d(0.2, 0.05, -0.03)},
          .half_extent = {0.7, 0.5},
          .power = 3,
          .pattern = std::move(pattern)};
}

cv::Mat_<float> white() {
  return {1, 1, 1.0F};
}

/// Returns the direction through a pixel of a projector's picture, projector's axes.
Vector3d through(const Projector& projector, const Vector2d& pixel) {
  const Vector2d size(projector.pattern.cols, projector.pattern.rows);
  const Vector2d place = 2 * (pixel.array() + 0.5) / size.array() - 1;
  return {place.x() * projector.half_extent.x(), place.y() * projector.half_extent.y(), 1};
}

/// A wall z = 2 - 0.3 x + 0.1 y before a camera at the origin.
Scene slanted_wall() {
  Scene scene;
  add(scene, quad({-4, -4, 2.8F}, {8, 0, -2.4F}, {0, 8, 0.8F}), diffuse({0.9F, 0.6F, 0.3F}));
  return scene;
}

const Vector3d kWallNormal = Vector3d(-0.3, 0.1, -1).normalized();

/// Returns where a line from a point meets the slanted wall.
Vector3d on_wall(const Vector3d& from, const Vector3d& along) {
  return from + along * (kWallNormal.dot(Vector3d(0, 0, 2) - from) / kWallNormal.dot(along));
}

vo::PinholeCamera fine_camera() {
  return vo::PinholeCamera::from_horizontal_fov(160, 120, 60);
}

Capture infrared(const vo::PinholeCamera& camera, const Projector& projector,
                 double scene_light = 0) {
  Capture capture = still(camera, {});
  capture.infrared = InfraredBand{scene_light, {projector}};
  return capture;
}

RenderedFrame seen(const Scene& scene, const Capture& capture, RenderOptions options = {}) {
  return make_renderer(scene, options)->render(capture);
}

/// Returns the centroid of an image's light, px.
Vector2d centroid(const cv::Mat_<cv::Vec3f>& image) {
  Vector2d sum(0, 0);
  double light = 0;
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      sum += image(v, u)[0] * Vector2d(u, v);
      light += image(v, u)[0];
    }
  }
  return sum / light;
}

TEST(Projector, ADotLiesWhereItsRayMeetsTheWall) {
  for (const cv::Point& pixel : {cv::Point(40, 30), cv::Point(14, 43), cv::Point(65, 12)}) {
    Projector projector = beside_camera(cv::Mat_<float>(60, 80, 0.0F));
    projector.pattern(pixel) = 1;
    const vo::SE3& T = projector.T_camera_projector;
    const Vector3d point =
        on_wall(T.translation(), T.rotation() * through(projector, {pixel.x, pixel.y}));
    const cv::Mat_<cv::Vec3f> image =
        seen(slanted_wall(), infrared(fine_camera(), projector), {.samples = 16}).radiance;
    EXPECT_LT((centroid(image) - fine_camera().project(point)).norm(), 0.1) << pixel;
  }
}

TEST(Projector, LightsAWallAsItsIntensityTowardsThePointSays) {
  cv::Mat_<float> pattern(30, 40);
  for (int i = 0; i < 1200; ++i) {  // linear, so that interpolation keeps it
    pattern(i / 40, i % 40) =
        0.01F * static_cast<float>(i % 40) + 0.015F * static_cast<float>(i / 40);
  }
  const Projector projector = beside_camera(pattern);
  const vo::PinholeCamera camera = fine_camera();
  constexpr double kSceneLight = 0.25;
  const Scene scene = slanted_wall();
  const cv::Mat_<cv::Vec3f> image =
      seen(scene, infrared(camera, projector, kSceneLight), {.samples = 1}).radiance;
  const cv::Mat_<cv::Vec3f> colors = render(scene, {.samples = 1}, camera).radiance;
  for (const cv::Point& pixel : {cv::Point(80, 60), cv::Point(35, 22), cv::Point(120, 95)}) {
    const Vector3d point = on_wall({0, 0, 0}, camera.unproject({pixel.x, pixel.y}, 1));
    const Vector3d to_light = projector.T_camera_projector.translation() - point;
    const Vector3d direction = projector.T_camera_projector.inverse() * point;
    const Vector2d place = direction.head<2>() / direction.z();
    const double u = 40 * (place.x() / 0.7 + 1) / 2 - 0.5;
    const double v = 30 * (place.y() / 0.5 + 1) / 2 - 0.5;
    const double intensity = 3 * (0.01 * u + 0.015 * v);
    const double irradiance =
        intensity * kWallNormal.dot(to_light.normalized()) / to_light.squaredNorm();
    const cv::Vec3f& of_scene = colors(pixel);
    const double expected =
        irradiance * 0.6 / kFlatAngle + kSceneLight * (of_scene[0] + of_scene[1] + of_scene[2]) / 3;
    EXPECT_NEAR(image(pixel)[1], expected, 1e-4 * expected) << pixel;
    EXPECT_EQ(image(pixel)[0], image(pixel)[2]);
  }
}

TEST(Projector, WhatItDoesNotSeeIsDark) {
  // From 0.2 m to the right the plate's shadow on the wall reaches from x = -0.4 to 0 m; the camera
  // sees of it what the plate does not hide, up to x = -0.2 m.
  Scene scene;
  add(scene, square_at(2, 3), diffuse({1, 1, 1}));
  add(scene, square_at(1, 0.1F), diffuse({1, 1, 1}));
  const Projector projector{.T_camera_projector = {Eigen::Quaterniond::Identity(), {0.2, 0, 0}},
                            .pattern = white()};
  const vo::PinholeCamera camera = fine_camera();
  const cv::Mat_<cv::Vec3f> image =
      seen(scene, infrared(camera, projector), {.samples = 1}).radiance;
  const auto at = [&](double x, double z) {
    const Vector2d pixel = camera.project(Vector3d(x, 0, z));
    return image(static_cast<int>(std::lround(pixel.y())),
                 static_cast<int>(std::lround(pixel.x())))[0];
  };
  EXPECT_GT(at(0, 1), 0);  // the plate itself
  EXPECT_GT(at(-0.42, 2), 0);
  EXPECT_EQ(at(-0.38, 2), 0);
  EXPECT_EQ(at(-0.22, 2), 0);
  EXPECT_GT(at(0.22, 2), 0);  // which a projector at the camera would see, too
}

TEST(Projector, LightsNothingOutsideOfItsPicture) {
  Scene scene;
  add(scene, square_at(2, 8), diffuse({1, 1, 1}));
  Projector projector{.half_extent = {0.5, 0.25}, .pattern = white()};
  const cv::Mat_<cv::Vec3f> image =
      seen(scene, infrared(wide_camera(), projector), {.samples = 1}).radiance;
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const Vector3d ray = wide_camera().unproject(Vector2d(u, v), 1);
      const bool is_lit = std::abs(ray.x()) < 0.5 && std::abs(ray.y()) < 0.25;
      EXPECT_EQ(image(v, u)[0] > 0, is_lit) << u << ", " << v;
    }
  }
}

/// Four by three bright squares on black.
cv::Mat_<float> checks() {
  cv::Mat_<float> pattern(60, 80, 0.0F);
  for (int i = 0; i < 12; ++i) {
    pattern(cv::Rect(20 * (i % 4) + 5, 20 * (i / 4) + 5, 10, 10)) = 1;
  }
  return pattern;
}

TEST(Projector, MovesWithItsCameraWhileRowsAreExposed) {
  // Along a wall without texture nothing changes for the two of them, whenever a row is exposed.
  Scene scene;
  add(scene, square_at(2, 16), diffuse({1, 1, 1}));
  Capture capture = infrared(fine_camera(), beside_camera(checks()));
  const cv::Mat_<cv::Vec3f> at_rest = seen(scene, capture).radiance;
  capture.motion = [](double time) {
    return vo::SE3(Eigen::Quaterniond::Identity(), Vector3d(2 * time, time, 0));
  };
  for (const Shutter& shutter : {Shutter{.readout_time = 0.1}, Shutter{.exposure_time = 0.1},
                                 Shutter{.exposure_time = 0.05, .readout_time = 0.05}}) {
    capture.shutter = shutter;
    EXPECT_LT(cv::norm(seen(scene, capture).radiance, at_rest, cv::NORM_INF), 1e-3);
  }
  // A pattern that stayed where it was would differ by its brightness.
  EXPECT_GT(cv::norm(at_rest, cv::NORM_INF), 0.1);
}

TEST(Projector, LightsThePathsOfModePathAsALampDoes) {
  Scene scene;
  add(scene, square_at(2, 3), diffuse({0.5F, 0.5F, 0.5F}));
  add(scene, quad({-3, 1, 0}, {6, 0, 0}, {0, 0, 2}), diffuse({0.5F, 0.5F, 0.5F}));
  Scene with_lamp = scene;
  with_lamp.lights.push_back(point_light({0, 0, 0}, {1, 1, 1}));
  Projector projector{.half_extent = {100, 100}, .pattern = white()};
  for (const int bounces : {0, 3}) {
    const RenderOptions options{
        .mode = RenderMode::path, .samples = 16, .ambient = 0, .bounces = bounces};
    const cv::Mat_<cv::Vec3f> image =
        seen(scene, infrared(wide_camera(), projector), options).radiance;
    // A lamp at the camera, seen through the same filter: the paths are the same.
    Capture lamp = still(wide_camera(), {});
    lamp.infrared = InfraredBand{1, {}};
    const cv::Mat_<cv::Vec3f> expected = seen(with_lamp, lamp, options).radiance;
    EXPECT_NEAR(cv::mean(image)[0], cv::mean(expected)[0], 0.02 * cv::mean(expected)[0]);
    EXPECT_GT(cv::mean(image)[0], 0.01);
  }
}

TEST(Projector, ItsPatternIsNotTakenForNoise) {
  Scene scene;
  add(scene, square_at(2, 16), diffuse({1, 1, 1}));
  const Capture capture = infrared(fine_camera(), beside_camera(checks()));
  const RenderOptions direct{.samples = 4};
  const RenderOptions denoised{
      .mode = RenderMode::path, .samples = 4, .bounces = 0, .denoise = true};
  EXPECT_LT(cv::norm(seen(scene, capture, denoised).radiance, seen(scene, capture, direct).radiance,
                     cv::NORM_INF),
            1e-5);
}

TEST(Projector, ChangesNoDepth) {
  const Scene scene = slanted_wall();
  const RenderedFrame lit = seen(scene, infrared(fine_camera(), beside_camera(white()), 1));
  const RenderedFrame colors = render(scene, {}, fine_camera());
  EXPECT_TRUE(have_same_pixels(lit.depth, colors.depth));
  EXPECT_FALSE(have_same_pixels(lit.radiance, grey_of(colors.radiance)));
}

TEST(Infrared, WithoutProjectorsIsAShareOfTheScenesGreyInEveryRendererAndMode) {
  Scene scene = slanted_wall();
  scene.lights.push_back(point_light({0.3, -0.5, 0}, {9, 8, 7}));
  Capture capture = still(fine_camera(), {});
  capture.infrared = InfraredBand{0.25, {}};
  for (const RenderOptions& options :
       {RenderOptions{.mode = RenderMode::direct}, RenderOptions{.mode = RenderMode::unlit},
        RenderOptions{.mode = RenderMode::path, .samples = 4},
        RenderOptions{.kind = RendererKind::rasterizer}}) {
    const cv::Mat_<cv::Vec3f> expected =
        grey_of(render(scene, options, fine_camera()).radiance, 0.25);
    EXPECT_LT(cv::norm(seen(scene, capture, options).radiance, expected, cv::NORM_INF), 1e-6);
  }
}

}  // namespace
}  // namespace synth
