#include "vo/alignment/surface_normal.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"

namespace {

using support::small_camera;
using vo::SE3;

vo::PyramidLevel level_of(const vo::RgbdFrame& frame) {
  return vo::build_pyramid(frame, small_camera(), {.levels = 1}).levels[0];
}

TEST(SurfaceNormal, OfAPlaneIsThePlanes) {
  for (const double angle : {0.0, 0.4, 1.1}) {
    const support::TexturedPlane plane{
        .normal = Eigen::Vector3d(std::sin(angle), 0.3, -std::cos(angle)).normalized()};
    const vo::PyramidLevel level = level_of(plane.render(small_camera(), SE3()));
    for (const cv::Point pixel : {cv::Point(160, 120), cv::Point(20, 200), cv::Point(310, 10)}) {
      const Eigen::Vector3d ray = small_camera().unproject({pixel.x, pixel.y}, 1);
      const Eigen::Vector3d expected = plane.normal / plane.normal.dot(ray);
      const auto found = vo::surface_normal(level, pixel);
      ASSERT_TRUE(found.has_value());
      EXPECT_LT((found->n.cast<double>() - expected).norm(), 1e-3 * expected.norm()) << angle;
      EXPECT_LT(found->deviation.norm(), 1e-3 * expected.norm()) << angle;
    }
  }
}

TEST(SurfaceNormal, DeviatesByHalfTheStepAtAStepOfDepth) {
  vo::RgbdFrame frame = support::blank_frame(small_camera(), 0, 0);
  frame.depth.colRange(60, frame.depth.cols) = 3.0F;
  const vo::PyramidLevel level = level_of(frame);
  const double slope = (2.0 / 3.0 - 1) * small_camera().fx / 2;  // of one side, 2 px wide
  const auto at_step = vo::surface_normal(level, {59, 50});
  ASSERT_TRUE(at_step.has_value());
  EXPECT_NEAR(at_step->n.x(), slope / 2, 1e-3);
  EXPECT_NEAR(at_step->deviation.x(), std::abs(slope) / 2, 1e-3);
  EXPECT_NEAR(at_step->deviation.y(), 0, 1e-6);
  const auto beside = vo::surface_normal(level, {63, 50});
  ASSERT_TRUE(beside.has_value());
  EXPECT_NEAR(beside->deviation.norm(), 0, 1e-6);
}

TEST(SurfaceNormal, IsNothingWithoutDepthAroundAndAtTheBorder) {
  vo::RgbdFrame frame = support::blank_frame(small_camera(), 0, 0);
  frame.depth(50, 62) = 0;
  const vo::PyramidLevel level = level_of(frame);
  for (const cv::Point pixel :
       {cv::Point(62, 50), cv::Point(60, 50), cv::Point(64, 50), cv::Point(62, 48),
        cv::Point(62, 52), cv::Point(1, 50), cv::Point(62, level.depth.rows - 2)}) {
    EXPECT_FALSE(vo::surface_normal(level, pixel).has_value()) << pixel;
  }
  EXPECT_TRUE(vo::surface_normal(level, {2, 2}).has_value());
  EXPECT_TRUE(vo::surface_normal(level, {61, 51}).has_value());
  frame.depth = {};
  EXPECT_FALSE(vo::surface_normal(level_of(frame), {62, 50}).has_value());
}

}  // namespace
