#include "vo/image/pyramid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"

namespace {

using support::small_camera;
using vo::DepthImage;
using vo::GrayImage;

DepthImage halved(const DepthImage& depth) {
  DepthImage half;
  vo::halve_depth(depth, half);
  return half;
}

/// I = a u + b v + c is halved to the same ramp in the pixels of the half image.
TEST(Pyramid, HalvingARampShiftsByHalfAPixel) {
  GrayImage ramp(8, 10);
  for (int v = 0; v < ramp.rows; ++v) {
    for (int u = 0; u < ramp.cols; ++u) {
      ramp(v, u) = 0.01F * static_cast<float>(u) + 0.02F * static_cast<float>(v) + 0.1F;
    }
  }
  GrayImage half;
  vo::halve(ramp, half);
  ASSERT_EQ(half.size(), cv::Size(5, 4));
  EXPECT_NEAR(half(1, 2), 0.01F * 4.5F + 0.02F * 2.5F + 0.1F, 1e-6);
}

TEST(Pyramid, GradientOfARampIsItsSlope) {
  GrayImage ramp(5, 6);
  for (int v = 0; v < ramp.rows; ++v) {
    for (int u = 0; u < ramp.cols; ++u) {
      ramp(v, u) = 0.01F * static_cast<float>(u) - 0.02F * static_cast<float>(v);
    }
  }
  const cv::Vec2f gradient = vo::central_gradient(ramp, {3, 2});
  EXPECT_NEAR(gradient[0], 0.01F, 1e-7);
  EXPECT_NEAR(gradient[1], -0.02F, 1e-7);
  EXPECT_EQ(vo::central_gradient(ramp, {3, 0}), cv::Vec2f(0, 0)) << "border";
}

TEST(Pyramid, DepthOfOneSurfaceIsTheMeanOfInverseDepths) {
  const DepthImage depth = (DepthImage(2, 2) << 2.0F, 2.02F, 2.04F, 2.06F);
  const float expected = 4 / (1 / 2.0F + 1 / 2.02F + 1 / 2.04F + 1 / 2.06F);
  EXPECT_NEAR(halved(depth)(0, 0), expected, 1e-6);
}

TEST(Pyramid, DepthIsNeverAveragedAcrossHolesOrSteps) {
  EXPECT_EQ(halved((DepthImage(2, 2) << 0.0F, 2.0F, 2.01F, 2.02F))(0, 0), 2.0F);
  EXPECT_EQ(halved((DepthImage(2, 2) << 4.0F, 0.0F, 0.0F, 0.0F))(0, 0), 4.0F);
  EXPECT_EQ(halved((DepthImage(2, 2) << 4.0F, 1.0F, 4.1F, 4.0F))(0, 0), 1.0F)
      << "the edge belongs to the occluder";
  EXPECT_EQ(halved(DepthImage(2, 2, 0.0F))(0, 0), 0.0F);
}

/// A level's camera sees the plane's exact depth at its own pixel centres.
TEST(Pyramid, LevelsAgreeWithTheirCameras) {
  const support::TexturedPlane plane;
  const vo::FramePyramid pyramid =
      vo::build_pyramid(plane.render(small_camera(), {}), small_camera(), {.levels = 4});
  ASSERT_EQ(pyramid.levels.size(), 4U);
  for (const vo::PyramidLevel& level : pyramid.levels) {
    EXPECT_EQ(level.intensity.cols, level.camera.width);
    EXPECT_EQ(level.depth.rows, level.camera.height);
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(3, 5), Eigen::Vector2d(20, 11)}) {
      const float measured = level.depth(static_cast<int>(pixel.y()), static_cast<int>(pixel.x()));
      EXPECT_NEAR(measured, plane.depth(level.camera, {}, pixel), 1e-5);
    }
  }
}

TEST(Pyramid, StopsBeforeImagesBecomeTooSmall) {
  const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(80, 60, 60);
  const support::TexturedPlane plane;
  EXPECT_EQ(vo::build_pyramid(plane.render(camera, {}), camera, {.levels = 5}).levels.size(), 2U);
}

bool are_same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

TEST(Pyramid, AnotherFrameTakesTheMemoryThatNobodyElseHolds) {
  const support::TexturedPlane plane;
  const vo::RgbdFrame first = plane.render(small_camera(), {});
  const vo::RgbdFrame second =
      plane.render(small_camera(), vo::SE3(Eigen::Quaterniond::Identity(), {0.1, 0, 0}));
  const vo::FramePyramid expected = vo::build_pyramid(second, small_camera(), {});
  vo::PyramidBuilder builder(small_camera(), {});
  vo::FramePyramid pyramid;
  builder.build(first, {}, pyramid);
  const vo::FramePyramid kept = pyramid;
  const GrayImage kept_before = kept.levels[1].intensity.clone();
  builder.build(second, {}, pyramid);
  EXPECT_TRUE(are_same(kept.levels[1].intensity, kept_before)) << "a copy was written to";
  const uchar* memory = pyramid.levels[1].depth.data;
  builder.build(first, {}, pyramid);
  builder.build(second, {}, pyramid);
  EXPECT_EQ(pyramid.levels[1].depth.data, memory);
  for (std::size_t l = 0; l < expected.levels.size(); ++l) {
    EXPECT_TRUE(are_same(pyramid.levels[l].intensity, expected.levels[l].intensity)) << l;
    EXPECT_TRUE(are_same(pyramid.levels[l].depth, expected.levels[l].depth)) << l;
  }
}

/// A fisheye lens shows nothing beyond 85 degrees, where drivers that fill holes still give depth.
TEST(Pyramid, ThereIsNoDepthWhereTheLensShowsNothing) {
  vo::PinholeCamera fisheye{
      .width = 160, .height = 120, .fx = 45, .fy = 45, .cx = 79.5, .cy = 59.5};
  fisheye.distortion.model = vo::DistortionModel::kannala_brandt;
  const DepthImage everywhere(fisheye.height, fisheye.width, 2.0F);
  const vo::FramePyramid pyramid =
      vo::build_pyramid({0, vo::ByteImage(fisheye.height, fisheye.width, uchar{90}), everywhere},
                        fisheye, {.levels = 3});
  for (const vo::PyramidLevel& level : pyramid.levels) {
    int unseen = 0;
    for (int v = 0; v < level.rays.rows; ++v) {
      for (int u = 0; u < level.rays.cols; ++u) {
        const bool has_ray = std::isfinite(level.rays(v, u)[0]);
        unseen += has_ray ? 0 : 1;
        const bool has_depth = level.depth(v, u) > 0;
        EXPECT_TRUE(has_ray || !has_depth) << u << " " << v;
      }
    }
    EXPECT_GT(unseen, 0);
  }
  EXPECT_EQ(pyramid.levels.front().depth(60, 80), 2.0F);
  EXPECT_EQ(everywhere(0, 0), 2.0F) << "the caller's depth stays";
}

}  // namespace
