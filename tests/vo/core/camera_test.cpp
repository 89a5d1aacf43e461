#include "vo/core/camera.h"

#include <gtest/gtest.h>

#include "vo/core/error.h"
#include "vo/io/camera_file.h"

namespace {

using vo::PinholeCamera;

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

TEST(Distortion, HasTheDerivativeOfItsDifferences) {
  const vo::Distortion lens = vo::load_camera("tum-fr1").pinhole.distortion;
  constexpr double kStep = 1e-6;
  for (const auto& [x, y] : {std::pair{0.3, -0.2}, std::pair{-0.5, 0.4}}) {
    const auto point = vo::distort(lens, x, y);
    const auto right = vo::distort(lens, x + kStep, y);
    const auto left = vo::distort(lens, x - kStep, y);
    const auto below = vo::distort(lens, x, y + kStep);
    const auto above = vo::distort(lens, x, y - kStep);
    EXPECT_NEAR(point.dx_dx, (right.x - left.x) / (2 * kStep), 1e-8);
    EXPECT_NEAR(point.dx_dy, (right.y - left.y) / (2 * kStep), 1e-8);
    EXPECT_NEAR(point.dx_dy, (below.x - above.x) / (2 * kStep), 1e-8) << "symmetric";
    EXPECT_NEAR(point.dy_dy, (below.y - above.y) / (2 * kStep), 1e-8);
  }
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

/// With k1 = -0.25 the image's radius r (1 - r^2 / 4) grows up to r = 1.15 only, where it is 0.77.
TEST(PinholeCamera, RejectsALensThatFoldsOverInsideTheImage) {
  PinholeCamera camera{.width = 160, .height = 120, .fx = 100, .fy = 100, .cx = 79.5, .cy = 59.5};
  camera.distortion.k1 = -0.25;
  EXPECT_THROW(camera.validate(), vo::Error) << "the corners are at radius 1.0";
  camera.fx = camera.fy = 200;
  EXPECT_NO_THROW(camera.validate()) << "the corners are at radius 0.5";
}

}  // namespace
