#include "vo/geometry/camera.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"

namespace {

using vo::PinholeCamera;

/// The left camera of the TUM VI benchmark, whose corners the lens does not reach.
PinholeCamera fisheye() {
  return {512,
          512,
          190.97847715128717,
          190.9733070521226,
          254.93170605935475,
          256.8974428996504,
          {.k1 = 0.0034823894022493434,
           .k2 = 0.0007150348452162257,
           .k3 = -0.0020532361418706202,
           .k4 = 0.00020293673591811182,
           .model = vo::DistortionModel::kannala_brandt}};
}

std::vector<PinholeCamera> cameras() {
  std::vector<PinholeCamera> result;
  for (const vo::CameraPreset& preset : vo::camera_presets()) {
    result.push_back(preset.camera.pinhole);
  }
  return result;
}

TEST(PinholeCamera, UnprojectInvertsProject) {
  for (const PinholeCamera& camera : cameras()) {
    for (int v = 0; v < camera.height; v += 40) {
      for (int u = 0; u < camera.width; u += 40) {
        const Eigen::Vector2d pixel(u, v);
        const Eigen::Vector3d p_camera = camera.unproject(pixel, 2.5);
        EXPECT_DOUBLE_EQ(p_camera.z(), 2.5) << "depth is along z";
        EXPECT_LT((camera.project(p_camera) - pixel).norm(), 1e-9) << u << " " << v;
      }
    }
  }
}

/// Figures of the TUM RGB-D benchmark's fr1 camera worked out by hand: (x, y) = (0.3, -0.2),
/// r^2 = 0.13.
TEST(PinholeCamera, ProjectsAsTheFormulaOfBrownAndConrady) {
  const PinholeCamera camera = vo::load_camera("tum-fr1").pinhole;
  const Eigen::Vector2d pixel = camera.project({0.6, -0.4, 2});
  const double radial =
      1 + 0.262383 * 0.13 - 0.953104 * 0.13 * 0.13 + 1.163314 * 0.13 * 0.13 * 0.13;
  const double x = 0.3 * radial + 2 * -0.005358 * 0.3 * -0.2 + 0.002628 * (0.13 + 2 * 0.09);
  const double y = -0.2 * radial + -0.005358 * (0.13 + 2 * 0.04) + 2 * 0.002628 * 0.3 * -0.2;
  EXPECT_NEAR(pixel.x(), 517.306408 * x + 318.643040, 1e-9);
  EXPECT_NEAR(pixel.y(), 516.469215 * y + 255.313989, 1e-9);
}

TEST(PinholeCamera, HalvedSeesTheSamePointAtHalfTheResolution) {
  for (const PinholeCamera& camera : cameras()) {
    const Eigen::Vector3d p_camera(0.2, 0.1, 1.5);
    const Eigen::Vector2d pixel = camera.project(p_camera);
    const Eigen::Vector2d half = camera.halved().project(p_camera);
    EXPECT_LT((half - (pixel + Eigen::Vector2d(0.5, 0.5)) / 2 + Eigen::Vector2d(0.5, 0.5)).norm(),
              1e-12);
  }
}

TEST(PinholeCamera, KeepsTheSignOfANegativeFocalLength) {
  const PinholeCamera camera = vo::load_camera("icl-nuim").pinhole;
  EXPECT_LT(camera.fy, 0);
  EXPECT_LT(camera.project({0, 1, 2}).y(), camera.cy) << "y up is up in the image";
}

TEST(PinholeCamera, FieldOfViewSpansTheImage) {
  const PinholeCamera camera = PinholeCamera::from_horizontal_fov(640, 480, 90);
  const Eigen::Vector3d left_edge = camera.unproject({-0.5, camera.cy}, 1);
  EXPECT_NEAR(left_edge.x(), -1, 1e-12);
  EXPECT_NEAR(left_edge.y(), 0, 1e-12);
}

TEST(PinholeCamera, RejectsWhatIsNoCamera) {
  PinholeCamera camera = vo::load_camera("tum-default").pinhole;
  EXPECT_NO_THROW(camera.validate());
  camera.fx = 0;
  EXPECT_THROW(camera.validate(), vo::Error);
  camera.fx = 500;
  camera.width = 0;
  EXPECT_THROW(camera.validate(), vo::Error);
}

TEST(PinholeCamera, RejectsWhatNoLensHas) {
  const PinholeCamera good{.width = 8, .height = 6, .fx = 1e-3, .fy = -1e9, .cx = -1e6, .cy = 1e6};
  EXPECT_NO_THROW(good.validate());
  for (double PinholeCamera::*field : {&PinholeCamera::fx, &PinholeCamera::fy}) {
    for (const double focal_px : {1e-20, 1e20}) {
      PinholeCamera camera = good;
      camera.*field = focal_px;
      EXPECT_THAT(support::error_text([&] { camera.validate(); }),
                  testing::HasSubstr("camera: expected focal lengths from 0.001 to 1e+09 px, got"));
    }
  }
  for (double PinholeCamera::*field : {&PinholeCamera::cx, &PinholeCamera::cy}) {
    PinholeCamera camera = good;
    camera.*field = -1e20;
    EXPECT_THAT(support::error_text([&] { camera.validate(); }),
                testing::HasSubstr("camera: expected cx and cy within 1e+06 px, got"));
  }
}

/// With k1 = -0.25 the image's radius r (1 - r^2 / 4) grows up to r = 1.15 only, where it is 0.77.
TEST(PinholeCamera, RejectsALensThatFoldsOverInsideTheImage) {
  PinholeCamera camera{.width = 160, .height = 120, .fx = 100, .fy = 100, .cx = 79.5, .cy = 59.5};
  camera.distortion.k1 = -0.25;
  EXPECT_THROW(camera.validate(), vo::Error) << "the corners are at radius 1.0";
  camera.fx = camera.fy = 200;
  EXPECT_NO_THROW(camera.validate()) << "the corners are at radius 0.5";
}

TEST(Fisheye, UnprojectInvertsProjectWhereTheLensSees) {
  const PinholeCamera camera = fisheye();
  EXPECT_NO_THROW(camera.validate());
  constexpr double kWidest = 85;  // deg
  int seen = 0;
  for (int v = 0; v < camera.height; v += 15) {
    for (int u = 0; u < camera.width; u += 15) {
      const Eigen::Vector2d pixel(u, v);
      const Eigen::Vector3d p_camera = camera.unproject(pixel, 2.5);
      // Its coefficients are small: the angle is the distance in focal lengths to a hundredth.
      const double off_axis_deg =
          std::hypot((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy) * 57.2957795;
      EXPECT_TRUE(p_camera.allFinite() || off_axis_deg > 0.98 * kWidest) << u << " " << v;
      if (p_camera.allFinite()) {
        EXPECT_LT((camera.project(p_camera) - pixel).norm(), 1e-9) << u << " " << v;
        EXPECT_LT(off_axis_deg, 1.02 * kWidest);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 800);
}

/// Without coefficients the distance from the principal point is f times the angle.
TEST(Fisheye, IsEquidistantWithoutCoefficients) {
  PinholeCamera camera{.width = 401, .height = 401, .fx = 100, .fy = 100, .cx = 200, .cy = 200};
  camera.distortion.model = vo::DistortionModel::kannala_brandt;
  for (const double angle : {0.0, 1e-9, 1e-4, 0.3, 0.9, 1.4}) {
    const Eigen::Vector2d pixel = camera.project({2 * std::tan(angle), 0, 2});
    EXPECT_NEAR(pixel.x(), 200 + 100 * angle, 1e-9);
    EXPECT_NEAR(pixel.y(), 200, 1e-9);
  }
}

TEST(Fisheye, RejectsWhatItsModelDoesNotHave) {
  PinholeCamera camera = fisheye();
  camera.distortion.p1 = 0.1;
  EXPECT_THROW(camera.validate(), vo::Error);
  camera = fisheye();
  camera.distortion.k1 = -0.3;  // a (1 - 0.3 a^2) grows up to a = 1.05
  EXPECT_THROW(camera.validate(), vo::Error);
  camera = fisheye();
  camera.distortion.k5 = 0.1;
  EXPECT_THROW(camera.validate(), vo::Error) << "Kannala and Brandt have no k5";
}

TEST(PinholeCamera, RejectsALensWhoseDenominatorEndsInsideTheImage) {
  PinholeCamera camera{640, 480, 400, 410, 320, 240, {-0.2, 0.05, 0.001, -0.002, 0.01, 0.1, 0.02}};
  camera.validate();
  camera.distortion = {.k4 = 2};  // r / (1 + 2 r^2) grows up to r = 0.71
  EXPECT_THROW(camera.validate(), vo::Error);
  camera.distortion = {.k1 = -3.1, .k4 = -3};  // turns back before a pole at r = 0.58
  EXPECT_THROW(camera.validate(), vo::Error);
}

}  // namespace
