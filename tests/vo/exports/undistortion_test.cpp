#include "vo/exports/undistortion.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "vo/dataset/camera_file.h"

namespace {

/// Cameras with barrel, pincushion and mixed distortion, and a fisheye of 130 deg across.
std::vector<vo::PinholeCamera> cameras_with_lenses() {
  return {{160, 120, 110, 112, 78, 61, {-0.28, 0.07, 0.001, -0.002, 0}},
          {160, 120, 110, 112, 78, 61, {0.12, 0.02, -0.001, 0.002, 0}},
          vo::load_camera("tum-fr1").pinhole.halved().halved(),
          {160,
           120,
           70,
           70,
           80,
           58,
           {.k1 = -0.013,
            .k2 = 0.021,
            .k3 = -0.012,
            .k4 = 0.0021,
            .model = vo::DistortionModel::kannala_brandt}}};
}

/// A plane across the view, its depth along the axis and its grey.
float plane_depth(const Eigen::Vector3d& direction) {
  return static_cast<float>(2 / (1 + 0.2 * direction.x() - 0.1 * direction.y()));
}

double plane_grey(const Eigen::Vector3d& direction) {
  return 120 + 60 * std::sin(2 * direction.x()) + 40 * std::cos(direction.y());
}

vo::RgbdFrame plane_seen_by(const vo::PinholeCamera& camera) {
  vo::RgbdFrame frame{1.5, vo::ByteImage(camera.height, camera.width),
                      vo::DepthImage(camera.height, camera.width)};
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector3d direction = camera.unproject({u, v}, 1);
      frame.image.at<uchar>(v, u) = cv::saturate_cast<uchar>(plane_grey(direction));
      frame.depth(v, u) = plane_depth(direction);
    }
  }
  return frame;
}

/// Each depth must be that of the plane within half a pixel of where the lens images it.
void expect_nearest_depth(const vo::PinholeCamera& lens, const vo::PinholeCamera& camera,
                          const vo::DepthImage& depth) {
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector2d origin = lens.project(camera.unproject({u, v}, 1));
      float least = 1e9F;
      float greatest = 0;
      for (const double du : {-0.52, 0.52}) {
        for (const double dv : {-0.52, 0.52}) {
          const float corner = plane_depth(lens.unproject(origin + Eigen::Vector2d(du, dv), 1));
          least = std::min(least, corner);
          greatest = std::max(greatest, corner);
        }
      }
      ASSERT_GE(depth(v, u), least) << u << ", " << v;
      ASSERT_LE(depth(v, u), greatest) << u << ", " << v;
    }
  }
}

TEST(Undistortion, ShowsWhatAPerfectLensWould) {
  for (const vo::PinholeCamera& lens : cameras_with_lenses()) {
    const vo::Undistortion undistortion(lens);
    EXPECT_TRUE(undistortion.camera().distortion.is_zero());
    EXPECT_EQ(undistortion.holes(), 0U);
    const vo::RgbdFrame straight = undistortion.apply(plane_seen_by(lens));
    const vo::RgbdFrame expected = plane_seen_by(undistortion.camera());
    EXPECT_EQ(straight.timestamp, 1.5);
    EXPECT_LE(cv::norm(straight.image, expected.image, cv::NORM_INF), 2) << "of 255";
    expect_nearest_depth(lens, undistortion.camera(), straight.depth);
  }
}

TEST(Undistortion, InventsNoPixelAndLosesNoMoreThanItMust) {
  for (const vo::PinholeCamera& lens : cameras_with_lenses()) {
    const vo::PinholeCamera camera = vo::Undistortion(lens).camera();
    double nearest_border = 1e9;
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        const Eigen::Vector2d origin = lens.project(camera.unproject({u, v}, 1));
        ASSERT_GE(std::min(origin.x(), origin.y()), -1e-6);
        ASSERT_LE(origin.x(), camera.width - 1 + 1e-6);
        ASSERT_LE(origin.y(), camera.height - 1 + 1e-6);
        nearest_border = std::min({nearest_border, origin.x(), origin.y(),
                                   camera.width - 1 - origin.x(), camera.height - 1 - origin.y()});
      }
    }
    EXPECT_TRUE(nearest_border < 1 || camera.fx == lens.fx / 2) << nearest_border << " px";
  }
}

TEST(Undistortion, OfAVeryWideFisheyeKeepsHalfTheResolutionOfItsMiddle) {
  const vo::PinholeCamera lens{
      160, 120, 40, 40, 79.5, 59.5, {.model = vo::DistortionModel::kannala_brandt}};
  const vo::PinholeCamera camera = vo::Undistortion(lens).camera();
  EXPECT_EQ(camera.fx, 20);
  EXPECT_EQ(camera.cx, 79.5);
  const vo::RgbdFrame straight = vo::Undistortion(lens).apply(plane_seen_by(lens));
  EXPECT_NEAR(straight.depth(60, 80), 2, 0.02);
}

TEST(Undistortion, AFrameWithoutDepthHasNoneAfterwards) {
  const vo::PinholeCamera lens = cameras_with_lenses().front();
  vo::RgbdFrame frame = plane_seen_by(lens);
  frame.depth = vo::DepthImage();
  EXPECT_TRUE(vo::Undistortion(lens).apply(frame).depth.empty());
}

}  // namespace
