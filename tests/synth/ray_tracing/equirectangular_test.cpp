#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "synth/ray_tracing/ray_tracer.h"
#include "synth/scene/texture.h"
#include "tests/support/box_room.h"
#include "tests/support/quads.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

const vo::EquirectangularCamera kPanorama{.width = 64, .height = 32};

vo::SE3 leaning_pose() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d(0.3, 1, 0.2).normalized())),
          Vector3d(0.4, -0.3, 0.2)};
}

/// Where a ray from within the box of these half sizes leaves it, m along the unit ray, and the
/// normal there, inwards.
struct WayOut {
  double distance;
  Vector3d normal;
};

WayOut way_out(const Vector3d& half, const Vector3d& eye, const Vector3d& ray) {
  const Vector3d wall = ray.cwiseSign().cwiseProduct(half);
  const Vector3d ways = (wall - eye).cwiseQuotient(ray);
  Eigen::Index axis = 0;
  const double distance = ways.minCoeff(&axis);
  return {distance, -ray.cwiseSign()[axis] * Vector3d::Unit(axis)};
}

/// Calls `check` with each pixel and its ray in the world's axes.
void visit_rays(const vo::CameraModel& camera, const vo::SE3& T_world_camera,
                const std::function<void(const cv::Point&, const Vector3d&)>& check) {
  for (int v = 0; v < camera.height(); ++v) {
    for (int u = 0; u < camera.width(); ++u) {
      check({u, v}, T_world_camera.rotation() * camera.ray({u, v}));
    }
  }
}

TEST(Equirectangular, DepthAndNormalsInABoxAreThoseOfItsClosedForm) {
  const Scene scene = support::box_room();
  const vo::SE3 T_world_camera = leaning_pose();
  Capture capture = still(kPanorama, T_world_camera);
  capture.channels = {.color = false, .depth = true, .normal = true, .ids = true};
  const RenderedFrame frame = make_ray_tracer(scene, {.samples = 1})->render(capture);
  visit_rays(kPanorama, T_world_camera, [&](const cv::Point& pixel, const Vector3d& ray) {
    const WayOut expected = way_out(support::kBoxRoomHalf, T_world_camera.translation(), ray);
    const cv::Vec3f& normal = frame.normal(pixel);
    EXPECT_NEAR(frame.depth(pixel), expected.distance, 1e-6) << pixel;
    EXPECT_LT(
        (T_world_camera.rotation() * Vector3d(normal[0], normal[1], normal[2]) - expected.normal)
            .norm(),
        1e-6)
        << pixel;
    EXPECT_GT(frame.instance(pixel), 0) << pixel;
  });
}

/// Each pixel sees what a pinhole camera of one pixel sees that looks there.
TEST(Equirectangular, SeesWhatPinholesSeeThatLookInEachDirection) {
  Scene scene = support::box_room();
  scene.lights.push_back(point_light({0.5, 0.4, -0.6}, {3, 2, 1}));
  for (Material& material : scene.materials) {
    material.unlit = false;
  }
  const vo::SE3 T_world_camera = leaning_pose();
  const auto renderer = make_ray_tracer(scene, {.samples = 1});
  Capture capture = still(kPanorama, T_world_camera);
  capture.channels = {.color = true, .depth = true, .normal = false, .ids = true};
  const RenderedFrame frame = renderer->render(capture);
  int different = 0;
  visit_rays(kPanorama, T_world_camera, [&](const cv::Point& pixel, const Vector3d& ray) {
    const vo::PinholeCamera one{.width = 1, .height = 1, .fx = 1, .fy = 1, .cx = 0, .cy = 0};
    Capture straight = still(one, {Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), ray),
                                   T_world_camera.translation()});
    straight.channels = capture.channels;
    const RenderedFrame seen = renderer->render(straight);
    const bool is_same = cv::norm(frame.radiance(pixel) - seen.radiance(0, 0)) < 1e-4 &&
                         std::abs(frame.depth(pixel) - seen.depth(0, 0)) < 2e-6 &&
                         frame.instance(pixel) == seen.instance(0, 0) &&
                         frame.material(pixel) == seen.material(0, 0);
    different += is_same ? 0 : 1;
  });
  EXPECT_LE(different, 4);  // rays that meet an edge between two tiles
}

TEST(Equirectangular, ATurnAboutTheVerticalShiftsTheColumnsRound) {
  const Scene scene = support::box_room();
  const auto renderer = make_ray_tracer(scene, {.samples = 9});
  const auto seen = [&](int columns) {
    const double angle = columns * 2 * std::numbers::pi / kPanorama.width;
    return renderer->render(
        kPanorama,
        {Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitY())), {0.3, -0.2, 0.5}});
  };
  const RenderedFrame ahead = seen(0);
  const RenderedFrame turned = seen(23);
  int different = 0;
  for (int v = 0; v < kPanorama.height; ++v) {
    for (int u = 0; u < kPanorama.width; ++u) {
      const int shifted = (u + 23) % kPanorama.width;
      EXPECT_NEAR(turned.depth(v, u), ahead.depth(v, shifted), 2e-6);
      different += cv::norm(turned.radiance(v, u) - ahead.radiance(v, shifted)) < 1e-5 ? 0 : 1;
    }
  }
  EXPECT_LE(different, 4);  // samples on an edge between two tiles
}

TEST(Equirectangular, RowsOfARollingShutterSeeFromTheirOwnPoses) {
  const Scene scene = support::box_room();
  const auto renderer = make_ray_tracer(scene, {.samples = 1});
  const CameraMotion motion = [](double time) {
    return vo::SE3(Eigen::Quaterniond(Eigen::AngleAxisd(3 * time, Vector3d::UnitX())),
                   Vector3d(5 * time, 0, -2 * time));
  };
  Capture capture = still(kPanorama, {});
  capture.motion = motion;
  capture.shutter.readout_time = 0.1;
  capture.channels.normal = true;
  const RenderedFrame rolling = renderer->render(capture);
  for (const int v : {0, 9, 31}) {
    Capture at_rest = still(kPanorama, motion(capture.shutter.row_time(v, kPanorama.height)));
    at_rest.channels = capture.channels;
    const RenderedFrame expected = renderer->render(at_rest);
    EXPECT_EQ(cv::norm(rolling.radiance.row(v), expected.radiance.row(v), cv::NORM_INF), 0) << v;
    EXPECT_EQ(cv::norm(rolling.depth.row(v), expected.depth.row(v), cv::NORM_INF), 0) << v;
    EXPECT_EQ(cv::norm(rolling.normal.row(v), expected.normal.row(v), cv::NORM_INF), 0) << v;
  }
}

/// An exposure in which the camera turns about the vertical blurs longitudes over the angle of the
/// turn, evenly.
TEST(Equirectangular, AnExposureBlursAlongTheWayOfTheTurn) {
  Scene scene;
  scene.environment.radiance.create(32, 64);
  for (int v = 0; v < 32; ++v) {
    for (int u = 0; u < 64; ++u) {
      const double longitude = 2 * std::numbers::pi * (u + 0.5) / 64;
      scene.environment.radiance(v, u) = cv::Vec3d::all(1 + std::sin(longitude));
    }
  }
  constexpr double kTurn = 0.4;  // rad in the exposure
  Capture capture = still(kPanorama, {});
  capture.shutter.exposure_time = 0.1;
  capture.motion = [](double time) {
    return vo::SE3(Eigen::Quaterniond(Eigen::AngleAxisd(kTurn * time / 0.1, Vector3d::UnitY())),
                   Vector3d::Zero());
  };
  const auto renderer = make_ray_tracer(scene, {.samples = 400});
  const RenderedFrame blurred = renderer->render(capture);
  const RenderedFrame sharp = renderer->render(still(kPanorama, {}));
  // The mean of 1 + sin over an angle is 1 + sin times a sinc.
  const double sinc = std::sin(kTurn / 2) / (kTurn / 2);
  for (const cv::Point& pixel : {cv::Point(0, 15), cv::Point(20, 3), cv::Point(63, 28)}) {
    EXPECT_NEAR(blurred.radiance(pixel)[0] - 1, sinc * (sharp.radiance(pixel)[0] - 1), 2e-3);
  }
}

/// A box with walls of fine noise.
Scene noisy_box() {
  constexpr int kTexels = 512;
  cv::Mat_<cv::Vec4b> texels(kTexels, kTexels);
  const vo::RandomField random(5, 7, 0);
  for (int v = 0; v < kTexels; ++v) {
    for (int u = 0; u < kTexels; ++u) {
      const auto grey = static_cast<std::uint8_t>(random.uniform(u, v) < 0.5 ? 0 : 255);
      texels(v, u) = {grey, grey, grey, 255};
    }
  }
  Scene scene;
  scene.textures.push_back({.image = 0});
  scene.images.push_back(build_mip_levels(texels, TexelEncoding::linear));
  Material material = unlit({1, 1, 1});
  material.base_color_texture.texture = 0;
  for (const float side : {-2.0F, 2.0F}) {
    add(scene, quad({-2, -2, side}, {4, 0, 0}, {0, 4, 0}), material);
    add(scene, quad({-2, side, -2}, {4, 0, 0}, {0, 0, 4}), material);
    add(scene, quad({side, -2, -2}, {0, 4, 0}, {0, 0, 4}), material);
  }
  return scene;
}

/// Root-mean-square difference of two renderings over some rows.
double difference(const RenderedFrame& a, const RenderedFrame& b, const cv::Range& rows) {
  const cv::Mat one = a.radiance.rowRange(rows);
  return cv::norm(one, cv::Mat(b.radiance.rowRange(rows)), cv::NORM_L2) /
         std::sqrt(3.0 * static_cast<double>(one.total()));
}

/// One sample with a footprint is nearer to the mean of many within the pixel than one that reads a
/// point, from pole to pole; nearest of all near the poles with the true footprint, of a narrow
/// pixel.
TEST(Equirectangular, TexturesAreFilteredOverThePixelFromPoleToPole) {
  Scene scene = noisy_box();
  const vo::SE3 T_world_camera(Eigen::Quaterniond::Identity(), {0.1, 0.05, -0.1});
  const auto seen = [&](int samples, int anisotropy = 1) {
    return make_ray_tracer(
               scene, {.mode = RenderMode::unlit, .samples = samples, .anisotropy = anisotropy})
        ->render(kPanorama, T_world_camera);
  };
  const RenderedFrame truth = seen(1024);
  const RenderedFrame round = seen(1);
  const RenderedFrame true_shape = seen(1, 16);
  scene.textures[0].mip = MipFilter::none;
  const RenderedFrame points = seen(1);
  for (const cv::Range& rows : {cv::Range(0, 4), cv::Range(4, 28), cv::Range(28, 32)}) {
    EXPECT_LT(difference(round, truth, rows), 0.2 * difference(points, truth, rows)) << rows.start;
    EXPECT_LT(difference(true_shape, truth, rows), difference(round, truth, rows)) << rows.start;
  }
}

TEST(Equirectangular, WhatAMirrorShowsIsAsFarAwayAsTheBoxBehindIt) {
  Scene scene = support::box_room();
  Material mirror = diffuse({1, 1, 1});
  mirror.metallic = 1;
  mirror.roughness = 0;
  add(scene, quad({-2, -1.5F, 1}, {4, 0, 0}, {0, 3, 0}), mirror);
  Capture capture = still(kPanorama, {Eigen::Quaterniond::Identity(), {0.4, -0.3, 0.2}});
  capture.channels = {.color = false, .depth = true, .normal = true, .sight = true};
  const RenderedFrame frame = make_ray_tracer(scene, {.mode = RenderMode::depth})->render(capture);
  int mirrored = 0;
  visit_rays(kPanorama, {}, [&](const cv::Point& pixel, const Vector3d& ray) {
    if (frame.sight.first(pixel) != static_cast<std::uint8_t>(FirstSurface::mirror)) {
      EXPECT_EQ(frame.sight.beyond(pixel), frame.depth(pixel));
      return;
    }
    ++mirrored;
    // The box from z = -2.5 to the mirror at z = 1, unfolded to z = 4.5.
    const Vector3d half(2, 1.5, 3.5);
    const WayOut expected = way_out(half, Vector3d(0.4, -0.3, 0.2 - 1), ray);
    EXPECT_NEAR(frame.sight.beyond(pixel), expected.distance, 4e-6) << pixel;
  });
  EXPECT_GT(mirrored, 300);
}

}  // namespace
}  // namespace synth
