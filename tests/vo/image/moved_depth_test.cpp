#include "vo/image/moved_depth.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/image/pyramid.h"

namespace {

/// Off its image's centre, with a lens.
vo::PinholeCamera example_camera() {
  return {200, 120, 160, 165, 103, 57, {0.05, -0.02, 0.002, -0.001, 0}};
}

vo::SE3 small_motion() {
  return vo::SE3::exp((vo::Vector6d() << 0.010, -0.006, 0.012, 0.012, -0.015, 0.010).finished());
}

vo::DepthImage moved(const vo::DepthImage& depth, const vo::PinholeCamera& camera,
                     const vo::SE3& T_moved_depth) {
  vo::DepthImage result;
  move_depth(depth, camera, vo::camera_levels(camera, {}).front().rays, T_moved_depth, result);
  return result;
}

/// Half a pixel of the plane's slope, 2 mm, is what the nearest pixel is off by; left where it was,
/// depth is off by the slope of three pixels and by what the camera moved forwards.
TEST(MovedDepth, IsThatOfThePlaneSeenFromTheOtherPose) {
  const vo::PinholeCamera camera = example_camera();
  const support::TexturedPlane plane;
  const vo::DepthImage before = plane.render(camera, small_motion()).depth;
  const vo::DepthImage after = plane.render(camera, {}).depth;
  const vo::DepthImage depth = moved(before, camera, small_motion());
  double worst = 0;
  double worst_unmoved = 0;
  for (int v = 6; v < depth.rows - 6; ++v) {
    for (int u = 6; u < depth.cols - 6; ++u) {
      worst = std::max<double>(worst, std::abs(depth(v, u) - after(v, u)));
      worst_unmoved = std::max<double>(worst_unmoved, std::abs(before(v, u) - after(v, u)));
    }
  }
  EXPECT_LT(worst, 0.005);
  EXPECT_GT(worst_unmoved, 0.015);
}

/// The motion is of two whole pixels, so each depth has one place.
TEST(MovedDepth, HolesAndBordersMoveWithTheImage) {
  const vo::PinholeCamera camera{100, 40, 100, 100, 49.5, 19.5};
  vo::DepthImage depth(40, 100, 2.0F);
  depth(20, 30) = 0;
  depth(10, 61) = 1.99F;
  const vo::SE3 T_moved_depth(Eigen::Quaterniond::Identity(), {0.04, -0.04, 0});
  const vo::DepthImage result = moved(depth, camera, T_moved_depth);
  for (int v = 0; v < result.rows; ++v) {
    for (int u = 0; u < result.cols; ++u) {
      const cv::Point source(u - 2, v + 2);
      const bool is_inside = source.inside({0, 0, depth.cols, depth.rows});
      EXPECT_EQ(result(v, u), is_inside ? depth(source) : 0) << u << "," << v;
    }
  }
}

TEST(MovedDepth, WithoutMotionItStays) {
  const vo::PinholeCamera camera = example_camera();
  const vo::DepthImage depth = support::TexturedPlane().render(camera, {}).depth;
  EXPECT_EQ(cv::norm(moved(depth, camera, {}), depth, cv::NORM_INF), 0);
}

}  // namespace
