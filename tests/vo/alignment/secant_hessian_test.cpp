#include "vo/alignment/secant_hessian.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace {

using vo::Matrix6d;
using vo::SecantHessian;
using vo::Vector6d;

/// Returns a positive definite matrix whose eigenvalues lie between about 1 and 7.
Matrix6d true_hessian() {
  Matrix6d A;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      A(row, column) = std::sin(1.0 + 3 * row + 5 * column);
    }
  }
  return A * A.transpose() + Matrix6d::Identity();
}

/// Returns a Hessian that overstates the true one by another factor in each direction, 1.2 to 2.2,
/// as that of weighted least squares does.
Matrix6d overstated(const Matrix6d& H) {
  const Eigen::LLT<Matrix6d> root(H);
  const Matrix6d L = root.matrixL();
  const Vector6d factors{1.2, 1.4, 1.6, 1.8, 2.0, 2.2};
  return L * factors.asDiagonal() * L.transpose();
}

double least_eigenvalue(const Matrix6d& H) {
  return Eigen::SelfAdjointEigenSolver<Matrix6d>(H).eigenvalues().minCoeff();
}

TEST(SecantHessian, IsTheGivenOneWithoutSteps) {
  EXPECT_EQ(SecantHessian().corrected(true_hessian()), true_hessian());
}

TEST(SecantHessian, MapsTheLastStepToTheChangeThatItMade) {
  const Matrix6d H = true_hessian();
  SecantHessian hessian;
  for (int i = 0; i < 9; ++i) {
    const Vector6d step = Vector6d::Unit(i % 6) + 0.3 * Vector6d::Unit((i + 2) % 6);
    hessian.add(step, H * step);
    const Matrix6d corrected = hessian.corrected(overstated(H));
    EXPECT_LT((corrected * step - H * step).norm(), 1e-12 * (H * step).norm());
    EXPECT_LT((corrected - corrected.transpose()).norm(), 1e-12 * H.norm());
    EXPECT_GT(least_eigenvalue(corrected), 0.5);
  }
}

/// Minimises a quadratic by steps of the overstated Hessian, corrected or not, and returns how far
/// the minimum is after the last of them.
double distance_after(int steps, bool is_corrected) {
  const Matrix6d H = true_hessian();
  Vector6d x = Vector6d::Constant(0.5);
  SecantHessian hessian;
  for (int i = 0; i < steps; ++i) {
    const Matrix6d used = is_corrected ? hessian.corrected(overstated(H)) : overstated(H);
    const Vector6d step = -used.ldlt().solve(H * x);
    x += step;
    hessian.add(step, H * step);
  }
  return x.norm();
}

TEST(SecantHessian, FindsAMinimumInFewerSteps) {
  EXPECT_GT(distance_after(6, false), 1e-3) << "a constant factor with each step";
  EXPECT_LT(distance_after(6, true), 0.1 * distance_after(6, false));
  EXPECT_LT(distance_after(12, true), 1e-3 * distance_after(12, false));
}

/// Noise can show a curvature that is negative, or that of another minimum.
TEST(SecantHessian, StaysPositiveWhereASlopeRisesAlongAStep) {
  const Matrix6d H = true_hessian();
  SecantHessian hessian;
  for (int i = 0; i < 8; ++i) {
    const Vector6d step = Vector6d::Unit(i % 6);
    const double curvature = step.dot(hessian.corrected(H) * step);
    hessian.add(step, -2 * H * step);
    const Matrix6d corrected = hessian.corrected(H);
    EXPECT_GT(least_eigenvalue(corrected), 0);
    if (i < 6) {  // later ones push out the first
      EXPECT_NEAR(step.dot(corrected * step), 0.3 * curvature, 1e-12 * curvature);
    }
  }
}

}  // namespace
