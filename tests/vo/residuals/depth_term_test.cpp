#include "vo/residuals/depth_term.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "tests/support/pose_near.h"
#include "tests/support/textured_plane.h"

namespace {

using support::PoseNear;
using support::small_camera;
using vo::SE3;
using vo::Vector6d;

/// The inside of a box around the origin: three walls in view determine six degrees of freedom.
const Eigen::Vector3d kHalfBox(1.2, 0.9, 2);  // m

double box_depth(const vo::PinholeCamera& camera, const SE3& T_world_camera,
                 const Eigen::Vector2d& pixel) {
  const Eigen::Vector3d ray = T_world_camera.rotation() * camera.unproject(pixel, 1);
  const Eigen::Vector3d eye = T_world_camera.translation();
  double nearest = 1e9;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    nearest = std::min(nearest, (std::copysign(kHalfBox[axis], ray[axis]) - eye[axis]) / ray[axis]);
  }
  return nearest;
}

vo::PyramidLevel box_level(const SE3& T_world_camera) {
  const vo::PinholeCamera camera = small_camera();
  vo::DepthImage depth(camera.height, camera.width);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      depth(v, u) = static_cast<float>(box_depth(camera, T_world_camera, {u, v}));
    }
  }
  return {camera, vo::camera_levels(camera, {.levels = 1}).front().rays, {}, {}, depth};
}

SE3 looking_into_a_corner() {
  Vector6d xi;
  xi << 0.1, -0.05, 0.1, 0.3, 0.35, 0.1;
  return SE3::exp(xi);
}

SE3 small_motion() {
  Vector6d xi;
  xi << 0.01, -0.008, 0.012, 0.006, -0.01, 0.008;
  return SE3::exp(xi);
}

TEST(SurfacePoints, LieOnTheWallsWithTheirNormals) {
  const SE3 T_world_camera = looking_into_a_corner();
  const vo::SurfacePoints points = vo::surface_points(box_level(T_world_camera));
  ASSERT_GT(points.size(), 300U);
  std::size_t on_walls = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = T_world_camera * points.position[i].cast<double>().eval();
    const Eigen::Vector3d n = T_world_camera.rotation() * points.normal[i].cast<double>();
    Eigen::Index wall = 0;
    const double off = (kHalfBox - p.cwiseAbs()).cwiseAbs().minCoeff(&wall);
    on_walls += off < 1e-5 && std::abs(std::abs(n[wall]) - 1) < 1e-6 ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(on_walls), 0.8 * static_cast<double>(points.size()))
      << "the others are around the corners, where a plane is nearly fitted";
}

TEST(SurfaceDistances, AreHowFarAWallIsOff) {
  vo::PyramidLevel level = box_level({});
  level.depth.setTo(2);
  const vo::SurfacePoints points = vo::surface_points(level);
  const SE3 T_cur_ref(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.02, 0, -0.03));
  std::vector<vo::SurfaceDistance> distances(3);
  vo::surface_distances({points, level, T_cur_ref}, distances);
  EXPECT_GT(distances.size(), points.size() / 2);
  for (const vo::SurfaceDistance& seen : distances) {
    EXPECT_NEAR(seen.depth, 1.97, 1e-5);
    EXPECT_NEAR(seen.distance, -0.03, 1e-5);
  }
}

TEST(SurfacePoints, AreNotTakenFromHolesOrSteps) {
  vo::PyramidLevel level = box_level({});
  level.depth.colRange(0, level.depth.cols / 2).setTo(0);
  level.depth.colRange(level.depth.cols / 2, level.depth.cols).setTo(1);
  level.depth.rowRange(level.depth.rows / 2, level.depth.rows) *= 2;
  for (const Eigen::Vector3f& p : vo::surface_points(level).position) {
    const Eigen::Vector2d pixel = level.camera.project(p.cast<double>());
    EXPECT_GT(pixel.x(), level.depth.cols / 2.0 + 2.9);
    EXPECT_GT(std::abs(pixel.y() - level.depth.rows / 2.0), 2.9);
  }
}

TEST(DepthTerm, FindsTheMotionInsideABox) {
  const SE3 T_world_ref = looking_into_a_corner();
  const SE3 T_cur_ref = small_motion();
  const vo::SurfacePoints surface = vo::surface_points(box_level(T_world_ref));
  const vo::PyramidLevel current = box_level(T_world_ref * T_cur_ref.inverse());
  SE3 estimate;
  for (int i = 0; i < 10; ++i) {
    const vo::NormalEquations<6> system = vo::linearize_depth({surface, current, estimate}, 1e-3);
    estimate = SE3::exp(Vector6d(-system.H.ldlt().solve(system.b))) * estimate;
  }
  EXPECT_THAT(estimate, PoseNear(T_cur_ref, support::PoseTolerance{3e-4, 0.01}));
}

TEST(DepthTerm, SpreadOfAnOffsetWallIsTheOffset) {
  const vo::PyramidLevel level = box_level({});
  vo::SurfacePoints wall;  // the far one, seen at right angles
  wall.position = {{0, 0, 2}, {0.2F, 0.1F, 2}, {-0.3F, 0, 2}};
  wall.normal = {3, Eigen::Vector3f(0, 0, 1)};
  const SE3 T_cur_ref = SE3(Eigen::Quaterniond::Identity(), {0, 0, 0.01});
  EXPECT_NEAR(vo::distance_spread({wall, level, T_cur_ref}), 1.4826 * 0.01, 1e-6);
}

TEST(DepthTerm, ScoresAddUpToTheSystem) {
  const vo::SurfacePoints surface = vo::surface_points(box_level(looking_into_a_corner()));
  const vo::PyramidLevel current = box_level(looking_into_a_corner());
  const vo::DepthView view{surface, current, small_motion()};
  Vector6d sum = Vector6d::Zero();
  std::vector<vo::DepthScore> scores;
  vo::score_depth(view, 2e-3, scores);
  for (const vo::DepthScore& score : scores) {
    sum += score.b;
  }
  EXPECT_LT((sum - vo::linearize_depth(view, 2e-3).b).norm(), 1e-5 * sum.norm());
}

/// A flat wall leaves three directions open; the others are determined by it.
TEST(DepthTerm, AWallDeterminesThreeDirections) {
  vo::PyramidLevel level = box_level({});
  level.depth.setTo(1.5F);
  const vo::SurfacePoints surface = vo::surface_points(level);
  const vo::NormalEquations<6> system = vo::linearize_depth({surface, level, SE3()}, 1e-3);
  const Eigen::SelfAdjointEigenSolver<vo::Matrix6d> solver(system.H);
  EXPECT_LT(solver.eigenvalues()[2], 1e-4 * solver.eigenvalues()[3]);
}

TEST(DepthAgreement, IsTheShareOfSurfacesThatAreMeasured) {
  vo::PyramidLevel level = box_level({});
  vo::SurfacePoints wall;  // the far one
  for (int i = 0; i < 100; ++i) {
    wall.position.emplace_back(0.01F * static_cast<float>(i - 50) + 0.005F, 0, 2);
    wall.normal.emplace_back(0, 0, 1);
  }
  EXPECT_EQ(vo::depth_agreement({wall, level, SE3()}), 1);
  const SE3 T_cur_ref(Eigen::Quaterniond::Identity(), {0, 0, 0.2});
  EXPECT_EQ(vo::depth_agreement({wall, level, T_cur_ref}), 0);

  cv::Mat left = level.depth.colRange(0, level.depth.cols / 2);
  left *= 0.9;
  EXPECT_EQ(vo::depth_agreement({wall, level, SE3()}), 0.5);
  left.setTo(0);
  EXPECT_EQ(vo::depth_agreement({wall, level, SE3()}), 1)
      << "where nothing is measured is not told";
  level.depth.setTo(0);
  EXPECT_EQ(vo::depth_agreement({wall, level, T_cur_ref}), 1);
}

}  // namespace
