#include "vo/geometry/camera_model.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "vo/geometry/field_of_view.h"

namespace vo {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using support::error_text;
using testing::HasSubstr;

const EquirectangularCamera kPanorama{.width = 128, .height = 64};

TEST(EquirectangularCamera, ImagesTheAxesWhereLongitudeAndLatitudeSay) {
  const std::vector<std::pair<Vector3d, Vector2d>> places{
      {{0, 0, 3}, {63.5, 31.5}},     {{2, 0, 0}, {95.5, 31.5}},  {{-2, 0, 0}, {31.5, 31.5}},
      {{1, 0, 1}, {79.5, 31.5}},     {{0, -1, 1}, {63.5, 15.5}}, {{0, 1, 1}, {63.5, 47.5}},
      {{0, -5, 0}, {63.5, -0.5}},    {{0, 5, 0}, {63.5, 63.5}},  {{1e-9, 0, -1}, {127.5, 31.5}},
      {{-1e-9, 0, -1}, {-0.5, 31.5}}};
  for (const auto& [point, pixel] : places) {
    EXPECT_LT((kPanorama.project(point) - pixel).norm(), 1e-6) << point.transpose();
  }
}

TEST(EquirectangularCamera, UnprojectInvertsProjectEverywhere) {
  for (double v = -0.4; v < 63.5; v += 1.3) {
    for (double u = -0.4; u < 127.5; u += 2.7) {
      const Vector3d point = kPanorama.unproject({u, v}, 2.5);
      EXPECT_NEAR(point.norm(), 2.5, 1e-12);
      EXPECT_LT((kPanorama.project(point) - Vector2d(u, v)).norm(), 1e-9) << u << ", " << v;
    }
  }
}

TEST(EquirectangularCamera, APixelIsAsWideAsItsSolidAngleSays) {
  double sphere = 0;
  for (int row = 0; row < kPanorama.height; ++row) {
    // The area between the pixel's borders, of thin quads that unproject makes.
    constexpr int kParts = 64;
    double area = 0;
    for (int i = 0; i < kParts; ++i) {
      const double v = row + (i + 0.5) / kParts - 0.5;
      const Vector3d left = kPanorama.unproject({9.5, v}, 1);
      const Vector3d right = kPanorama.unproject({10.5, v}, 1);
      const double longitude = 2 * std::asin((right - left).norm() / 2);
      area += longitude * std::numbers::pi / kPanorama.height / kParts;
    }
    const double solid_angle = pixel_solid_angle(row, kPanorama.height);
    EXPECT_NEAR(area, solid_angle, 2e-3 * solid_angle) << row;
    sphere += kPanorama.width * solid_angle;
  }
  EXPECT_NEAR(sphere, 4 * std::numbers::pi, 1e-12);
}

TEST(EquirectangularCamera, TheDerivativesOfARayAreItsChangeFromPixelToPixel) {
  constexpr double kStep = 1e-5;  // px
  for (const Vector2d& pixel : {Vector2d(3, 0), Vector2d(70.25, 20.5), Vector2d(127, 63)}) {
    const auto [by_column, by_row] = kPanorama.ray_derivatives(pixel);
    const auto change = [&](const Vector2d& step) {
      return Vector3d(
          (kPanorama.unproject(pixel + step, 1) - kPanorama.unproject(pixel - step, 1)) /
          (2 * kStep));
    };
    EXPECT_LT((by_column - change({kStep, 0})).norm(), 1e-10);
    EXPECT_LT((by_row - change({0, kStep})).norm(), 1e-10);
  }
}

TEST(EquirectangularCamera, ExpectsTheWholeSphere) {
  EXPECT_THAT(error_text([] { (EquirectangularCamera{.width = 128, .height = 63}).validate(); }),
              HasSubstr("twice as wide as high, got 128x63 px"));
  EXPECT_THAT(error_text([] { EquirectangularCamera().validate(); }), HasSubstr("got 0x0"));
  EXPECT_NO_THROW(kPanorama.validate());
}

TEST(CameraModel, OfAPinholeIsThePinhole) {
  PinholeCamera pinhole = PinholeCamera::from_horizontal_fov(64, 48, 70);
  pinhole.distortion = {.k1 = -0.1, .p1 = 0.001};
  const CameraModel camera = pinhole;
  EXPECT_EQ(camera.projection(), CameraProjection::pinhole);
  EXPECT_TRUE(camera.has_optical_axis());
  EXPECT_FALSE(camera.wraps());
  const Vector3d point(0.3, -0.2, 1.7);
  EXPECT_EQ(camera.project(point), pinhole.project(point));
  EXPECT_EQ(camera.ray({3, 40}), pinhole.unproject({3, 40}, 1));
  EXPECT_EQ(camera.depth(point), 1.7);
  for (const Vector3d& p : {point, Vector3d(-point), Vector3d(9, 0, 1)}) {
    EXPECT_EQ(camera.sees(p), is_in_view(pinhole, p));
  }
  EXPECT_EQ(camera.displacement({60, 3}, {2, 5}), Vector2d(-58, 2));
  EXPECT_EQ(&camera.pinhole_for("test"), camera.pinhole());
}

TEST(CameraModel, WithoutAnOpticalAxisCountsDepthAlongTheRay) {
  const CameraModel camera = kPanorama;
  EXPECT_FALSE(camera.has_optical_axis());
  for (const Vector3d& point : {Vector3d(1, 2, -2), Vector3d(0, -3, 0), Vector3d(0.1, 0, 4)}) {
    EXPECT_TRUE(camera.sees(point));
    EXPECT_NEAR(camera.depth(point), point.norm(), 1e-12);
    EXPECT_LT((camera.depth(point) * camera.ray(camera.project(point)) - point).norm(), 1e-9);
  }
  EXPECT_FALSE(camera.sees(Vector3d::Zero()));
  EXPECT_FALSE(CameraModel(PinholeCamera()).pixel_sides({0, 0}).has_value());
  EXPECT_NEAR(camera.pixel_sides({5, 7}).value()[1].norm(), camera.pixel_width(), 1e-12);
}

TEST(CameraModel, TheWayAcrossTheSeamIsTheShorterOne) {
  const CameraModel camera = kPanorama;
  EXPECT_EQ(camera.displacement({126, 3}, {1, 5}), Vector2d(3, 2));
  EXPECT_EQ(camera.displacement({1, 5}, {126, 3}), Vector2d(-3, -2));
  EXPECT_EQ(camera.displacement({10, 0}, {70, 0}), Vector2d(60, 0));
  EXPECT_EQ(std::abs(camera.displacement({10, 0}, {74, 0}).x()), 64);
}

TEST(CameraModel, ResizedKeepsTheView) {
  const CameraModel pinhole = PinholeCamera::from_horizontal_fov(64, 48, 70);
  const CameraModel half = pinhole.resized(32, 24);
  EXPECT_LT((half.ray({-0.5, -0.5}) - pinhole.ray({-0.5, -0.5})).norm(), 1e-12);
  EXPECT_LT((half.ray({31.5, 23.5}) - pinhole.ray({63.5, 47.5})).norm(), 1e-12);
  const CameraModel small = CameraModel(kPanorama).resized(33, 20);
  EXPECT_EQ(small.width(), 32);
  EXPECT_EQ(small.height(), 16);
}

TEST(CameraModel, NamesWhatNeedsAPinhole) {
  EXPECT_THAT(error_text([] { CameraModel(kPanorama).pinhole_for("sensor.lens"); }),
              "sensor.lens: expected a pinhole camera, got projection = \"equirectangular\"");
}

}  // namespace
}  // namespace vo
