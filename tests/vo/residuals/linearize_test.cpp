#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/warp_oracle.h"
#include "vo/alignment/align.h"
#include "vo/dataset/camera_file.h"

namespace {

using vo::SE3;
using vo::Vector6d;

constexpr double kPoseStep = 1e-6;  // m and rad
constexpr double kRelativeTolerance = 1e-5;

/// A smooth image and its derivative, everywhere.
double smooth_image(double u, double v) {
  return std::sin(0.05 * u + 0.02 * v) * std::cos(0.03 * v);
}

Eigen::Vector2d smooth_gradient(double u, double v) {
  const double c = std::cos(0.05 * u + 0.02 * v);
  const double s = std::sin(0.05 * u + 0.02 * v);
  return {0.05 * c * std::cos(0.03 * v),
          0.02 * c * std::cos(0.03 * v) - 0.03 * s * std::sin(0.03 * v)};
}

SE3 some_pose() {
  Vector6d xi;
  xi << 0.1, -0.2, 0.15, 0.05, -0.1, 0.2;
  return SE3::exp(xi);
}

double intensity(const vo::PinholeCamera& camera, const SE3& T_cur_ref,
                 const Eigen::Vector3d& p_ref) {
  const auto point = vo::warp_point<double>(vo::Warp<double>(camera, T_cur_ref), p_ref);
  return smooth_image(point.u, point.v);
}

Vector6d analytic(const vo::PinholeCamera& camera, const Eigen::Vector3d& p_ref) {
  const auto point = vo::warp_point<double>(vo::Warp<double>(camera, some_pose()), p_ref);
  const Eigen::Vector2d gradient = smooth_gradient(point.u, point.v);
  return support::forward_jacobian(point, gradient.x(), gradient.y());
}

using Perturbation = std::function<SE3(const Vector6d& delta)>;

Vector6d numeric(const vo::PinholeCamera& camera, const Eigen::Vector3d& p_ref,
                 const Perturbation& perturbed) {
  Vector6d J;
  for (int i = 0; i < 6; ++i) {
    const Vector6d delta = kPoseStep * Vector6d::Unit(i);
    J(i) =
        (intensity(camera, perturbed(delta), p_ref) - intensity(camera, perturbed(-delta), p_ref)) /
        (2 * kPoseStep);
  }
  return J;
}

/// The largest relative difference over a grid of points, for cameras with and without distortion.
double worst_difference(const Perturbation& perturbed) {
  std::vector<vo::PinholeCamera> cameras;
  for (const char* name : {"tum-fr1", "tum-default", "icl-nuim"}) {
    cameras.push_back(vo::load_camera(name).pinhole);
  }
  cameras.push_back({640, 480, 250, 251, 320, 239, {.k1 = -0.01, .k2 = 0.004}});
  cameras.back().distortion.model = vo::DistortionModel::kannala_brandt;
  double worst = 0;
  for (const vo::PinholeCamera& camera : cameras) {
    for (int v = 30; v < camera.height; v += 60) {
      for (int u = 30; u < camera.width; u += 60) {
        const Eigen::Vector3d p_ref = camera.unproject({u, v}, 1.0 + 0.003 * u);
        const Vector6d J = analytic(camera, p_ref);
        worst = std::max(worst, (J - numeric(camera, p_ref, perturbed)).norm() / J.norm());
      }
    }
  }
  return worst;
}

TEST(ForwardJacobian, MatchesCentralDifferencesOfTheLeftIncrement) {
  EXPECT_LT(worst_difference([](const Vector6d& delta) { return SE3::exp(delta) * some_pose(); }),
            kRelativeTolerance);
}

TEST(ForwardJacobian, IsNotThatOfTheRightIncrement) {
  EXPECT_GT(worst_difference([](const Vector6d& delta) { return some_pose() * SE3::exp(delta); }),
            0.01);
}

/// The projection is the camera's own, which is tested by itself.
TEST(Warp, ProjectsAsTheCamera) {
  const vo::PinholeCamera camera = vo::load_camera("tum-fr1").pinhole;
  const Eigen::Vector3d p_ref(0.3, -0.2, 1.7);
  const auto point = vo::warp_point<double>(vo::Warp<double>(camera, some_pose()), p_ref);
  const Eigen::Vector2d pixel = camera.project(some_pose() * p_ref);
  EXPECT_NEAR(point.u, pixel.x(), 1e-9);
  EXPECT_NEAR(point.v, pixel.y(), 1e-9);
}

/// An image that bilinear interpolation and central differences represent exactly.
vo::PyramidLevel bilinear_level(const vo::PinholeCamera& camera) {
  vo::PyramidLevel level{camera, {}, vo::GrayImage(camera.height, camera.width)};
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      level.intensity(v, u) = 2e-3F * static_cast<float>(u) - 1e-3F * static_cast<float>(v) +
                              1e-5F * static_cast<float>(u * v);
    }
  }
  return level;
}

vo::EdgePointLevel grid_of_points(const vo::PinholeCamera& camera) {
  vo::EdgePointLevel points;
  for (int v = 40; v < camera.height - 40; v += 7) {
    for (int u = 40; u < camera.width - 40; u += 7) {
      const Eigen::Vector3d p = camera.unproject({u, v}, 1.5 + 0.002 * u + 0.001 * v);
      points.x_ref.push_back(static_cast<float>(p.x()));
      points.y_ref.push_back(static_cast<float>(p.y()));
      points.z_ref.push_back(static_cast<float>(p.z()));
      points.intensity.push_back(0.3F);
      points.pixel.emplace_back(u, v);
    }
  }
  return points;
}

double cost_at(const vo::EdgePointLevel& points, const vo::PyramidLevel& level, const SE3& T) {
  return vo::linearize({points, level, T, {}, {}}, {.loss = vo::RobustLoss::none}, {1, {}}).cost;
}

/// With rho(r) = r^2 the cost has the derivative 2 b.
TEST(Linearize, RightHandSideIsTheGradientOfTheCost) {
  const vo::PinholeCamera camera = vo::load_camera("tum-default").pinhole;
  const vo::PyramidLevel level = bilinear_level(camera);
  const vo::EdgePointLevel points = grid_of_points(camera);
  Vector6d xi;
  xi << 0.01, -0.01, 0.02, 0.005, -0.005, 0.01;
  const SE3 T = SE3::exp(xi);
  const vo::PointEquations system =
      vo::linearize({points, level, T, {}, {}}, {.loss = vo::RobustLoss::none}, {1, {}});
  ASSERT_EQ(system.points, points.size()) << "all in view";
  constexpr double kCostStep = 1e-3;
  for (int i = 0; i < 6; ++i) {
    const Vector6d delta = kCostStep * Vector6d::Unit(i);
    const double slope = (cost_at(points, level, SE3::exp(delta) * T) -
                          cost_at(points, level, SE3::exp(-delta) * T)) /
                         (2 * kCostStep);
    const double expected = 2 * system.b(i);
    EXPECT_NEAR(slope, expected, 1e-3 * std::abs(expected) + 1e-3) << "component " << i;
  }
}

/// All points have one intensity: a gain and an offset of opposite effect go unseen.
TEST(Linearize, BrightnessCanBeEliminatedWithoutContrast) {
  const vo::PinholeCamera camera = vo::load_camera("tum-default").pinhole;
  const vo::PyramidLevel level = bilinear_level(camera);
  const vo::EdgePointLevel points = grid_of_points(camera);
  const vo::AlignOptions options{.loss = vo::RobustLoss::none,
                                 .brightness = vo::BrightnessModel::affine};
  const vo::PointEquations system = vo::linearize({points, level, SE3(), {}, {}}, options, {1, {}});
  const Eigen::Vector2d columns(points.intensity.front(), 1);
  const auto n = static_cast<double>(system.points);
  const Eigen::Matrix2d expected =
      n * columns * columns.transpose() + 1e-3 * (n + 1) * Eigen::Matrix2d::Identity();
  EXPECT_LT((system.trailing<2>().H - expected).norm(), 1e-5 * n);
}

TEST(Linearize, LeavingTheViewIsNoWayToLowerTheCost) {
  const vo::PinholeCamera camera = vo::load_camera("tum-default").pinhole;
  vo::PyramidLevel level = bilinear_level(camera);
  const vo::EdgePointLevel points = grid_of_points(camera);
  const SE3 T_away(Eigen::Quaterniond::Identity(), {100, 0, 0});
  const vo::AlignOptions options;
  const vo::PointEquations away =
      vo::linearize({points, level, T_away, {}, {}}, options, {options.loss_scale, {}});
  EXPECT_EQ(away.points, 0U);
  EXPECT_NEAR(away.cost / static_cast<double>(away.total), options.loss_scale * options.loss_scale,
              1e-9);
}

}  // namespace
