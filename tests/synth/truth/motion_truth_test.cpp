#include "synth/truth/motion_truth.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/truth/pixel_truth.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

/// A wall at 2 m that fills the view.
Scene wall() {
  Scene scene;
  add(scene, square_at(2, 20), unlit({1, 1, 1}));
  return scene;
}

/// A square of half a metre at 1 m in front of the wall.
Scene square_and_wall() {
  Scene scene = wall();
  add(scene, square_at(1, 0.25F), unlit({1, 0, 0}));
  return scene;
}

vo::SE3 small_motion() {
  vo::Vector6d tangent;
  tangent << 0.07, -0.04, 0.1, 0.02, -0.03, 0.05;
  return vo::SE3::exp(tangent);
}

Eigen::Matrix3d intrinsics(const vo::PinholeCamera& camera) {
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();
  K(0, 0) = camera.fx;
  K(1, 1) = camera.fy;
  K(0, 2) = camera.cx;
  K(1, 2) = camera.cy;
  return K;
}

TEST(OpticalFlow, OfAPlaneIsThatOfItsHomography) {
  const vo::PinholeCamera camera = wide_camera();
  const Scene scene = wall();
  const PointTracer tracer(scene);
  const vo::SE3 T_world_next = small_motion();
  const FlowImage flow =
      optical_flow(tracer.trace(camera, {}), NextView{tracer, camera, T_world_next});
  // A plane n . p = d in the first camera: p_next = (R + t n^T / d) p.
  const vo::SE3 T_next_now = T_world_next.inverse();
  const Eigen::Matrix3d K = intrinsics(camera);
  const Eigen::Matrix3d H =
      K *
      (T_next_now.rotation_matrix() + T_next_now.translation() * Eigen::RowVector3d(0, 0, 1) / 2) *
      K.inverse();
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector2d target = (H * Eigen::Vector3d(u, v, 1)).hnormalized();
      EXPECT_NEAR(flow(v, u)[0], target.x() - u, 1e-5);
      EXPECT_NEAR(flow(v, u)[1], target.y() - v, 1e-5);
    }
  }
}

TEST(OpticalFlow, AgreesWithDepthAndPoseThroughALens) {
  vo::PinholeCamera camera = wide_camera();
  camera.distortion = {0.1, -0.05, 0.002, -0.003, 0.01};
  const Scene scene = square_and_wall();
  const PointTracer tracer(scene);
  const vo::SE3 T_world_now = support::example_pose(0.1) * support::example_pose(0).inverse();
  const vo::SE3 T_world_next = T_world_now * small_motion();
  const PointImage points = tracer.trace(camera, T_world_now);
  const FlowImage flow = optical_flow(points, NextView{tracer, camera, T_world_next});
  const vo::DepthImage depth = depth_truth(points);
  const vo::SE3 T_next_now = T_world_next.inverse() * T_world_now;
  int checked = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector3d p_next = T_next_now * camera.unproject({u, v}, depth(v, u));
      if (depth(v, u) > 0 && p_next.z() > 0) {
        const Eigen::Vector2d expected = camera.project(p_next) - Eigen::Vector2d(u, v);
        EXPECT_NEAR(flow(v, u)[0], expected.x(), 1e-4);
        EXPECT_NEAR(flow(v, u)[1], expected.y(), 1e-4);
        ++checked;
      } else {
        EXPECT_GT(flow(v, u)[0], 1e9F);
      }
    }
  }
  EXPECT_GT(checked, 2000);
}

/// A camera that steps 0.31 m to the right sees the square's pixels move by 0.31 f to the left, the
/// wall's by half of that. Hidden are those of the wall whose targets the moved square covers.
TEST(Occlusion, BehindASquareIsWhatItsShadowCovers) {
  const vo::PinholeCamera camera = wide_camera();
  const Scene scene = square_and_wall();
  const PointTracer tracer(scene);
  const vo::SE3 T_world_next(Eigen::Quaterniond::Identity(), {0.31, 0, 0});
  const auto fates = occlusion(tracer.trace(camera, {}), NextView{tracer, camera, T_world_next});
  const double f = camera.fx;
  int hidden = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double x = u - camera.cx;
      const double y = v - camera.cy;
      const bool is_square = std::abs(x) < 0.25 * f && std::abs(y) < 0.25 * f;
      const double target = x - 0.31 * f / (is_square ? 1 : 2);
      const bool is_hidden =
          !is_square && std::abs(target + 0.31 * f) < 0.25 * f && std::abs(y) < 0.25 * f;
      const bool is_outside = target + camera.cx < -0.5;
      const PointFate expected = is_outside  ? PointFate::outside
                                 : is_hidden ? PointFate::occluded
                                             : PointFate::visible;
      EXPECT_EQ(fates(v, u), static_cast<std::uint8_t>(expected)) << u << ", " << v;
      hidden += is_hidden ? 1 : 0;
    }
  }
  EXPECT_GT(hidden, 50);
}

TEST(Occlusion, OfNothingIsNothing) {
  Scene scene;
  add(scene, square_at(1, 0.25F), unlit({1, 0, 0}));
  const PointTracer tracer(scene);
  const PointImage points = tracer.trace(wide_camera(), {});
  const NextView next{tracer, wide_camera(), {}};
  EXPECT_EQ(occlusion(points, next)(0, 0), static_cast<std::uint8_t>(PointFate::nothing));
  EXPECT_EQ(occlusion(points, next)(24, 32), static_cast<std::uint8_t>(PointFate::visible));
  EXPECT_GT(optical_flow(points, next)(0, 0)[1], 1e9F);
  EXPECT_NEAR(optical_flow(points, next)(24, 32)[1], 0, 1e-6);
}

/// The square moves 0.1 m to the right and 0.5 m away in front of a camera at rest.
TEST(MovingObjects, CarryTheirPointsWithThem) {
  const vo::PinholeCamera camera = wide_camera();
  const Scene now = square_and_wall();
  Scene then = now;
  then.instances.back().T_world_mesh.translate(Eigen::Vector3d(0.1, 0, 0.5));
  const PointTracer tracer(now);
  const PointTracer other(then);
  const PointImage points = tracer.trace(camera, {});
  const auto moved = moved_points(points, tracer, other);
  const FlowImage flow = optical_flow(points, NextView{other, camera, {}});
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double x = u - camera.cx;
      const double y = v - camera.cy;
      const bool is_square = std::abs(x) < 0.25 * camera.fx && std::abs(y) < 0.25 * camera.fx;
      EXPECT_EQ(moved(v, u), is_square ? 255 : 0);
      EXPECT_NEAR(flow(v, u)[0], is_square ? (x + 0.1 * camera.fx) / 1.5 - x : 0, 1e-5);
      EXPECT_NEAR(flow(v, u)[1], is_square ? y / 1.5 - y : 0, 1e-5);
    }
  }
}

/// The polynomial of this lens images what is 61 degrees off its axis near the image's middle.
TEST(Occlusion, IsOutsideWhereTheLensFoldsBack) {
  const Scene scene = wall();
  const PointTracer tracer(scene);
  vo::PinholeCamera folding = wide_camera();
  folding.fx = folding.fy = 120;
  folding.distortion.k1 = -0.3;
  const vo::SE3 aside(Eigen::Quaterniond(Eigen::AngleAxisd(1.0647, Eigen::Vector3d::UnitY())),
                      {0, 0, 0});
  const auto fates = occlusion(tracer.trace(wide_camera(), {}), NextView{tracer, folding, aside});
  EXPECT_EQ(fates(24, 32), static_cast<std::uint8_t>(PointFate::outside));
}

}  // namespace
}  // namespace synth
