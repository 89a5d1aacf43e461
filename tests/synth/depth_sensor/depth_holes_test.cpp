#include "synth/depth_sensor/depth_holes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/depth_sensor/depth_registration.h"
#include "synth/depth_sensor/plane_view.h"

namespace synth {
namespace {

vo::PinholeCamera plain_camera() {
  return {.width = 160, .height = 120, .fx = 140, .fy = 140, .cx = 79.5, .cy = 59.5};
}

/// Columns 60 to 99 of a box at 1 m before a wall at 2 m.
DepthView box_before_wall() {
  DepthView view = plane_view(plain_camera(), 2, 0);
  view.depth.colRange(60, 100).setTo(1);
  return view;
}

/// A depth camera beside and behind the colour camera, m.
vo::SE3 at(double x, double z) {
  return {Eigen::Quaterniond::Identity(), {x, 0, z}};
}

/// A depth camera that is turned about an axis of the colour camera's.
vo::SE3 turned(double angle_deg, const Eigen::Vector3d& axis) {
  const Eigen::AngleAxisd rotation(angle_deg * std::numbers::pi / 180, axis);
  return {Eigen::Quaterniond(rotation), Eigen::Vector3d::Zero()};
}

TEST(SecondView, LosesTheDifferenceOfDisparitiesBesideTheNearerSurface) {
  const DepthView view = box_before_wall();  // disparities of 10.5 and 5.25 px
  const cv::Mat_<uchar> right = seen_from_beside(view.depth, 140, 0.075, false);
  const cv::Mat_<uchar> left = seen_from_beside(view.depth, 140, -0.075, false);
  for (int u = 0; u < 160; ++u) {
    EXPECT_EQ(right(50, u) == 0, u >= 55 && u < 60) << u;
    EXPECT_EQ(left(50, u) == 0, u >= 100 && u < 105) << u;
  }
}

TEST(SecondView, OfAFrameLosesTheDisparityAtItsBorder) {
  const cv::Mat_<uchar> seen =
      seen_from_beside(plane_view(plain_camera(), 2, 0).depth, 140, 0.1, true);
  EXPECT_EQ(cv::countNonZero(seen.row(0)), 160 - 7);  // 7 px
  EXPECT_EQ(seen(0, 6), 0);
  EXPECT_EQ(seen(0, 7), 255);
}

double kept_share(double lean_deg, const DepthHoles& holes) {
  const vo::PinholeCamera camera{
      .width = 160, .height = 120, .fx = 5e4, .fy = 5e4, .cx = 79.5, .cy = 59.5};
  const DepthView view = plane_view(camera, 2, lean_deg);
  return cv::countNonZero(with_holes(view.depth, view, camera, holes, 0)) / (160.0 * 120);
}

TEST(DepthHoles, AreWhereSurfacesAreSeenAtAGrazingAngle) {
  EXPECT_EQ(kept_share(81, {.max_incidence_deg = 82}), 1);
  EXPECT_EQ(kept_share(83, {.max_incidence_deg = 82}), 0);
}

TEST(DepthHoles, GrowLinearlyUpToTheGreatestIncidence) {
  const DepthHoles holes{.max_incidence_deg = 80, .sure_incidence_deg = 70};
  EXPECT_EQ(kept_share(69, holes), 1);
  EXPECT_NEAR(kept_share(73, holes), 0.7, 4 * std::sqrt(0.21 / 19200) + 0.01);
  EXPECT_NEAR(kept_share(78, holes), 0.2, 4 * std::sqrt(0.16 / 19200) + 0.01);
}

TEST(DepthHoles, AreWhereDepthStepsTooFar) {
  const DepthView view = box_before_wall();
  const auto lost = [&](double step) {
    const vo::DepthImage kept = with_holes(view.depth, view, plain_camera(), {.max_step = step}, 0);
    return 160 * 120 - cv::countNonZero(kept);
  };
  EXPECT_EQ(lost(0.8), 4 * 120);  // a pixel on both sides of both edges
  EXPECT_EQ(lost(1.1), 0);
}

TEST(DepthHoles, TakeTheirShareOfEdges) {
  const DepthView view = box_before_wall();
  const vo::DepthImage kept = with_holes(view.depth, view, plain_camera(), {.edge_loss = 0.5}, 0);
  EXPECT_NEAR(160 * 120 - cv::countNonZero(kept), 240, 4 * std::sqrt(480 * 0.25));
}

TEST(DepthHoles, AreWhereTheImageIsDark) {
  vo::ColorImage image(2, 2, cv::Vec3b(20, 20, 20));
  image(0, 1) = {10, 10, 10};
  const vo::DepthImage kept = without_dark(vo::DepthImage(2, 2, 1.0F), image, 15);
  EXPECT_EQ(kept(0, 1), 0);
  EXPECT_EQ(cv::countNonZero(kept), 3);
}

TEST(FlyingPixels, AreBetweenBothSurfacesAndOnlyBesideEdges) {
  const DepthView view = box_before_wall();
  const vo::DepthImage measured = with_flying_pixels(view.depth, view.depth, {.share = 0.5}, 0);
  int flying = 0;
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const float depth = measured(v, u);
      const bool changed = depth != view.depth(v, u);
      const bool at_edge = u == 59 || u == 60 || u == 99 || u == 100;
      EXPECT_TRUE(!changed || (at_edge && depth >= 1 && depth <= 2));
      flying += changed ? 1 : 0;
    }
  }
  EXPECT_NEAR(flying, 240, 4 * std::sqrt(480 * 0.25));
}

TEST(Registered, DepthMovesByItsDisparityAndKeepsTheNearest) {
  // The depth camera is 25 mm to the left: 3.5 px at 1 m, 1.75 px at 2 m to the left in colour.
  const vo::DepthImage depth = registered(box_before_wall().depth, plain_camera(), at(-0.025, 0));
  EXPECT_EQ(depth(60, 70), 1);
  EXPECT_EQ(depth(60, 57), 1) << "60 - 3.5 rounded";
  EXPECT_EQ(depth(60, 54), 2);
  EXPECT_EQ(depth(60, 97), 0) << "not seen by the depth camera";
  EXPECT_EQ(depth(60, 99), 2);
  EXPECT_EQ(depth(60, 159), 0) << "beyond its image";
}

TEST(Registered, DepthOfACameraFurtherBackIsLess) {
  const vo::DepthImage depth =
      registered(plane_view(plain_camera(), 2, 0).depth, plain_camera(), at(0, -0.1));
  EXPECT_FLOAT_EQ(depth(60, 80), 1.9F);
}

TEST(Registered, DepthOfACameraTurnedAboutItsAxisHasNoHoles) {
  const vo::DepthImage wall = plane_view(plain_camera(), 2, 0).depth;
  for (const double angle_deg : {10, 45, 80}) {
    const vo::DepthImage depth =
        registered(wall, plain_camera(), turned(angle_deg, Eigen::Vector3d::UnitZ()));
    for (int v = 20; v < 100; ++v) {
      for (int u = 40; u < 120; ++u) {
        ASSERT_FLOAT_EQ(depth(v, u), 2) << angle_deg << " deg, " << u << ", " << v;
      }
    }
    EXPECT_EQ(depth(0, 0), 0) << "beyond the turned image";
  }
}

TEST(Registered, DepthOfACameraTurnedAsideIsThatOfALeaningWall) {
  const vo::PinholeCamera camera = plain_camera();
  const vo::SE3 T_color_depth = turned(20, Eigen::Vector3d::UnitY());
  const vo::DepthImage depth = registered(plane_view(camera, 2, 0).depth, camera, T_color_depth);
  const Eigen::Vector3d normal = T_color_depth.rotation() * Eigen::Vector3d::UnitZ();
  for (int u = 60; u < 150; ++u) {
    const double expected = 2 / normal.dot(camera.unproject({u, 59}, 1));
    const double beside = 2 / normal.dot(camera.unproject({u - 1, 59}, 1));
    // A pixel covers those beside it, too, and the nearest depth wins.
    EXPECT_NEAR(depth(59, u), expected, 1.5 * std::abs(beside - expected)) << u;
  }
}

}  // namespace
}  // namespace synth
