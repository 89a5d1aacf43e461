#include "tools/pictures/scene_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"

namespace {

tools::SceneView plane_view(const vo::PinholeCamera& camera, int frame) {
  const vo::RgbdFrame plane = support::sway_frame(camera, frame);
  const vo::FramePyramid pyramid = vo::build_pyramid(plane, camera, {.levels = 1});
  return tools::scene_view(plane.timestamp, pyramid.levels.front(),
                           cv::Mat_<cv::Vec3b>(camera.height, camera.width, cv::Vec3b(1, 2, 3)));
}

std::int16_t int16_at(const std::string& bytes, std::size_t index) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes.at(i)); };
  return static_cast<std::int16_t>(byte(2 * index) | byte(2 * index + 1) << 8U);
}

TEST(SceneView, PointsOfAllViewsLieOnThePlaneInTheWorld) {
  const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(160, 120, 60);
  vo::Trajectory trajectory;
  std::vector<tools::SceneView> views;
  for (int i = 0; i < 3; ++i) {
    trajectory.push_back({i / 30.0, support::sway(i)});
    views.push_back(plane_view(camera, i));
  }
  const auto points = tools::merge_views(views, trajectory, 100000);
  const support::TexturedPlane plane;
  EXPECT_GT(points.size(), 3000U);
  for (const tools::ColouredPoint& point : points) {
    EXPECT_NEAR(plane.normal.dot(point.position.cast<double>() - plane.point), 0, 2e-6);
    EXPECT_EQ(point.rgb[0], 3) << "BGR has become RGB";
  }
}

TEST(SceneView, MergingKeepsToTheLimitAndNeedsAPose) {
  const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(160, 120, 60);
  const std::vector<tools::SceneView> views = {plane_view(camera, 0)};
  const vo::Trajectory trajectory = {{0, {}}, {1, {}}};
  const std::size_t kept = tools::merge_views(views, trajectory, 100).size();
  EXPECT_LE(kept, 100U);
  EXPECT_GE(kept, 40U) << "a voxel grows by a quarter: at most 1.25^3 times too few";
  EXPECT_TRUE(tools::merge_views(views, {{5, {}}, {6, {}}}, 100).empty());
}

TEST(SceneView, QuantisedPointsReadBackToHalfAStep) {
  const std::vector<tools::ColouredPoint> points = {
      {{-1, 2, 3}, {1, 2, 3}}, {{4, -5, 6}, {4, 5, 6}}, {{0.1F, 0.2F, 0.3F}, {7, 8, 9}}};
  const tools::PointCloud cloud = tools::quantised(points);
  ASSERT_EQ(cloud.count, 3U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(cloud.origin.at(axis) + cloud.step * int16_at(cloud.positions, 3 * i + axis),
                  points[i].position[static_cast<Eigen::Index>(axis)], cloud.step / 2 + 1e-6);
    }
  }
  EXPECT_EQ(cloud.colours, "\1\2\3\4\5\6\7\10\11");
  EXPECT_EQ(tools::quantised({}).count, 0U);
}

}  // namespace
