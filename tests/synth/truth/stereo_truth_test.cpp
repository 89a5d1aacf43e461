#include "synth/truth/stereo_truth.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/truth/motion_truth.h"
#include "synth/truth/pixel_truth.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

constexpr double kBaseline = 0.1;  // m

/// A square of half a metre at 1 m in front of a wall at 2 m.
Scene square_before_wall() {
  Scene scene;
  add(scene, square_at(2, 20), unlit({1, 1, 1}));
  add(scene, square_at(1, 0.25F), unlit({1, 0, 0}));
  return scene;
}

TEST(StereoTruth, DisparityIsFocalLengthTimesBaselineOverDepth) {
  const vo::PinholeCamera camera = wide_camera();
  const Scene scene = square_before_wall();
  const PointTracer tracer(scene);
  const PointImage points = tracer.trace(camera, {});
  const cv::Mat_<float> disparity = disparity_truth(points, camera.fx * kBaseline);
  const double of_square = camera.fx * kBaseline / 1;
  const double of_wall = camera.fx * kBaseline / 2;
  int on_square = 0;
  for (const float d : disparity) {
    const double expected = std::abs(d - of_square) < 1e-4 ? of_square : of_wall;
    EXPECT_NEAR(d, expected, 1e-4);
    on_square += expected == of_square ? 1 : 0;
  }
  EXPECT_GT(on_square, 0);
}

TEST(StereoTruth, ThePartnerSeesThePointWhereDisparitySays) {
  const vo::PinholeCamera camera = wide_camera();
  const Scene scene = square_before_wall();
  const PointTracer tracer(scene);
  const vo::SE3 T_world_left = support::example_pose(0.1) * support::example_pose(0).inverse();
  const vo::SE3 T_world_right = T_world_left * T_left_right(kBaseline);
  const PointImage points = tracer.trace(camera, T_world_left);
  const cv::Mat_<float> disparity = disparity_truth(points, camera.fx * kBaseline);
  const vo::DepthImage depth = depth_truth(points);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      if (depth(v, u) > 0) {
        const Eigen::Vector3d p_world = T_world_left * camera.unproject({u, v}, depth(v, u));
        const Eigen::Vector2d seen = camera.project(T_world_right.inverse() * p_world);
        EXPECT_NEAR(u - seen.x(), disparity(v, u), 1e-4);
        EXPECT_NEAR(v, seen.y(), 1e-4);
      } else {
        EXPECT_EQ(disparity(v, u), 0);
      }
    }
  }
}

TEST(StereoTruth, NothingHasNoDisparity) {
  Scene scene;
  add(scene, square_at(1, 0.05F), unlit({1, 0, 0}));
  const vo::PinholeCamera camera = wide_camera();
  const PointTracer tracer(scene);
  const cv::Mat_<float> disparity = disparity_truth(tracer.trace(camera, {}), 10);
  EXPECT_EQ(disparity(0, 0), 0);
}

}  // namespace
}  // namespace synth
