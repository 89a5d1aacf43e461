#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "synth/truth/edge_labels.h"
#include "synth/truth/motion_truth.h"
#include "synth/truth/pixel_truth.h"
#include "tests/support/box_room.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const vo::EquirectangularCamera kPanorama{.width = 64, .height = 32};

vo::SE3 turned(double angle, const Vector3d& position = Vector3d::Zero()) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitY())), position};
}

TEST(EquirectangularTruth, FlowIsTheWayToTheMovedPointsPixelAcrossTheSeam) {
  const Scene scene = support::box_room();
  const PointTracer tracer(scene);
  const vo::SE3 T_world_next(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Vector3d(0.1, 1, -0.2).normalized())),
      {0.3, 0.1, -0.2});
  const PointImage points = tracer.trace(kPanorama, {});
  const FlowImage flow = optical_flow(points, {tracer, kPanorama, T_world_next});
  const vo::DepthImage depth = depth_truth(points);
  int across = 0;
  for (int v = 0; v < kPanorama.height; ++v) {
    for (int u = 0; u < kPanorama.width; ++u) {
      const Vector3d p_next = T_world_next.inverse() * kPanorama.unproject({u, v}, depth(v, u));
      const double right = u + static_cast<double>(flow(v, u)[0]);
      across += right < -0.5 || right > 63.5 ? 1 : 0;
      EXPECT_LE(std::abs(flow(v, u)[0]), 32);
      // The pixel that the flow leads to, beyond the border, too, sees along the moved point.
      const Vector3d ray = kPanorama.unproject({right, v + static_cast<double>(flow(v, u)[1])}, 1);
      EXPECT_LT((ray - p_next.normalized()).norm(), 2e-6) << u << ", " << v;
    }
  }
  EXPECT_GT(across, 30);
}

TEST(EquirectangularTruth, FlowOfATurnAboutTheVerticalIsOneNumber) {
  const Scene scene = support::box_room();
  const PointTracer tracer(scene);
  const double column = 2 * std::numbers::pi / kPanorama.width;
  const FlowImage flow =
      optical_flow(tracer.trace(kPanorama, {}), {tracer, kPanorama, turned(5.25 * column)});
  for (const cv::Vec2f& way : flow) {
    EXPECT_NEAR(way[0], -5.25, 1e-5);
    EXPECT_NEAR(way[1], 0, 1e-5);
  }
}

TEST(EquirectangularTruth, NothingIsOutsideAndWhatIsBehindASquareIsHidden) {
  Scene scene = support::box_room();
  add(scene, quad({-0.5F, -0.5F, -1}, {1, 0, 0}, {0, 1, 0}), unlit({1, 1, 1}));  // at the seam
  const PointTracer tracer(scene);
  const vo::SE3 T_world_next = turned(0, {0.4, 0, 0});
  const PointImage points = tracer.trace(kPanorama, {});
  const cv::Mat_<std::uint8_t> fates = occlusion(points, {tracer, kPanorama, T_world_next});
  int hidden = 0;
  for (int v = 0; v < kPanorama.height; ++v) {
    for (int u = 0; u < kPanorama.width; ++u) {
      // By the square's plane: where the line from the next eye to the point crosses it.
      const Vector3d point = tracer.position(points.at(u, v));
      const Vector3d eye = T_world_next.translation();
      const double share = (-1 - eye.z()) / (point.z() - eye.z());
      const Vector3d crossing = eye + share * (point - eye);
      const bool is_behind = share > 0 && share < 1 - 1e-9 &&
                             std::max(std::abs(crossing.x()), std::abs(crossing.y())) < 0.5;
      EXPECT_EQ(fates(v, u),
                static_cast<std::uint8_t>(is_behind ? PointFate::occluded : PointFate::visible))
          << u << ", " << v;
      hidden += is_behind ? 1 : 0;
    }
  }
  EXPECT_GT(hidden, 5);
}

TEST(EquirectangularTruth, EdgesGoOnAcrossTheSeam) {
  Scene scene = support::box_room();
  add(scene, quad({-0.5F, -0.5F, -1}, {1, 0, 0}, {0, 1, 0}), unlit({1, 1, 1}));
  const SurfaceTracer tracer(scene, 0.3);
  constexpr int kTurn = 29;  // columns
  const auto labels = [&](int columns) {
    const double angle = columns * 2 * std::numbers::pi / kPanorama.width;
    return edge_labels(tracer.trace(kPanorama, turned(angle, {0.05, 0.02, 0.01})), kPanorama, {});
  };
  const EdgeLabels ahead = labels(0);
  const EdgeLabels aside = labels(kTurn);
  int edges = 0;
  for (int v = 0; v < kPanorama.height; ++v) {
    for (int u = 0; u < kPanorama.width; ++u) {
      EXPECT_EQ(aside(v, u), ahead(v, (u + kTurn) % kPanorama.width)) << u << ", " << v;
      edges += aside(v, u) != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(edges, 100);
}

}  // namespace
}  // namespace synth
