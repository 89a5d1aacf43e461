#include "vo/geometry/se3.h"

#include <numbers>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <unsupported/Eigen/MatrixFunctions>

#include "tests/support/pose_near.h"

namespace {

using support::PoseNear;
using vo::SE3;
using vo::Vector6d;

constexpr support::PoseTolerance kRounding{.translation_m = 1e-10, .rotation_deg = 1e-6};

Vector6d tangent(double x, double y, double z, double rx, double ry, double rz) {
  Vector6d result;
  result << x, y, z, rx, ry, rz;
  return result;
}

/// Identity, tiny, around the change to the series, ordinary, near pi.
std::vector<Vector6d> tangents() {
  const double pi = std::numbers::pi;
  return {Vector6d::Zero(),
          tangent(1, -2, 3, 0, 0, 0),
          tangent(1, 2, 3, 1e-12, -1e-12, 2e-12),
          tangent(0.1, 0.2, -0.3, 0.9e-4, 0, 0),
          tangent(0.1, 0.2, -0.3, 0, 1.1e-4, 0),
          tangent(-1, 0.5, 2, 0.3, -0.2, 0.5),
          tangent(0, 1, 0, -1, 2, 0.5),
          tangent(1, 1, 1, 0, 0, pi - 1e-7),
          tangent(1, 1, 1, pi - 1e-10, 0, 0)};
}

Eigen::Matrix4d matrix(const SE3& T) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M.topLeftCorner<3, 3>() = T.rotation_matrix();
  M.topRightCorner<3, 1>() = T.translation();
  return M;
}

TEST(Se3, LogInvertsExp) {
  for (const Vector6d& xi : tangents()) {
    EXPECT_LT((SE3::exp(xi).log() - xi).norm(), 1e-8) << xi.transpose();
  }
}

TEST(Se3, ExpIsTheMatrixExponential) {
  for (const Vector6d& xi : tangents()) {
    Eigen::Matrix4d hat = Eigen::Matrix4d::Zero();
    hat.topLeftCorner<3, 3>() = vo::skew(xi.tail<3>());
    hat.topRightCorner<3, 1>() = xi.head<3>();
    EXPECT_LT((matrix(SE3::exp(xi)) - hat.exp()).norm(), 1e-10) << xi.transpose();
  }
}

TEST(Se3, ProductIsTheMatrixProduct) {
  for (const Vector6d& a : tangents()) {
    for (const Vector6d& b : tangents()) {
      const SE3 T_a = SE3::exp(a);
      const SE3 T_b = SE3::exp(b);
      EXPECT_LT((matrix(T_a * T_b) - matrix(T_a) * matrix(T_b)).norm(), 1e-11);
    }
  }
}

TEST(Se3, InverseUndoes) {
  for (const Vector6d& xi : tangents()) {
    const SE3 T = SE3::exp(xi);
    EXPECT_THAT(T * T.inverse(), PoseNear(SE3(), kRounding));
    const Eigen::Vector3d p(0.3, -4, 2);
    EXPECT_LT((T.inverse() * (T * p) - p).norm(), 1e-12);
  }
}

TEST(Se3, AngleIsTheNormOfTheRotationVector) {
  for (const Vector6d& xi : tangents()) {
    EXPECT_NEAR(SE3::exp(xi).angle(), xi.tail<3>().norm(), 1e-12);
  }
}

TEST(Se3, StaysOrthonormalOverTenThousandConstantVelocityCompositions) {
  SE3 T_world_last;
  SE3 T_world_current = SE3::exp(tangent(0.01, 0, 0.02, 0.01, -0.02, 0.015));
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const SE3 T_last_current = T_world_last.inverse() * T_world_current;
    T_world_last = T_world_current;
    T_world_current = T_world_current * T_last_current;
    const Eigen::Matrix3d R = T_world_current.rotation_matrix();
    worst = std::max(worst, (R.transpose() * R - Eigen::Matrix3d::Identity()).norm());
  }
  EXPECT_LT(worst, 1e-12);
}

/// Derivatives of the composed increment by both factors' increments carry their covariances on.
TEST(Se3, CompoundedCovarianceIsThatOfTheComposedIncrement) {
  const SE3 T_a_b = SE3::exp(tangent(0.3, -0.2, 0.5, 0.4, -0.3, 0.2));
  const SE3 T_b_c = SE3::exp(tangent(-0.1, 0.4, 0.2, -0.2, 0.5, 0.1));
  const vo::Matrix6d root_a_b = vo::Matrix6d::Identity() + 0.3 * adjoint(T_b_c);
  const vo::Matrix6d root_b_c = 0.5 * adjoint(T_a_b);
  constexpr double kStep = 1e-6;
  vo::Matrix6d J_a_b;
  vo::Matrix6d J_b_c;
  for (int k = 0; k < 6; ++k) {
    const Vector6d step = kStep * Vector6d::Unit(k);
    const SE3 T_a_c_inverse = (T_a_b * T_b_c).inverse();
    J_a_b.col(k) = (SE3::exp(step) * T_a_b * T_b_c * T_a_c_inverse).log() / kStep;
    J_b_c.col(k) = (T_a_b * SE3::exp(step) * T_b_c * T_a_c_inverse).log() / kStep;
  }
  const vo::Matrix6d of_a_b = root_a_b * root_a_b.transpose();
  const vo::Matrix6d of_b_c = root_b_c * root_b_c.transpose();
  const vo::Matrix6d expected =
      J_a_b * of_a_b * J_a_b.transpose() + J_b_c * of_b_c * J_b_c.transpose();
  EXPECT_LT((vo::compounded_covariance(T_a_b, of_a_b, of_b_c) - expected).norm(),
            1e-5 * expected.norm());
}

TEST(Se3, LookAtShowsTheTargetInTheCentreAndUpUpwards) {
  const Eigen::Vector3d eye(1, 2, 3);
  const Eigen::Vector3d target(-2, 1, 0.5);
  const SE3 T_world_camera = vo::look_at(eye, target, Eigen::Vector3d::UnitY());
  const Eigen::Vector3d p_camera = T_world_camera.inverse() * target;
  EXPECT_NEAR(p_camera.x(), 0, 1e-12);
  EXPECT_NEAR(p_camera.y(), 0, 1e-12);
  EXPECT_NEAR(p_camera.z(), (target - eye).norm(), 1e-12);
  const Eigen::Vector3d above = T_world_camera.inverse() * (target + Eigen::Vector3d::UnitY());
  EXPECT_LT(above.y(), 0) << "image y points down";
  EXPECT_NEAR(above.x(), 0, 1e-12) << "up has no sideways part";
  EXPECT_NEAR(T_world_camera.rotation_matrix().determinant(), 1, 1e-12);
}

}  // namespace
