#include "vo/core/normal_equations.h"

#include <cmath>

#include <Eigen/QR>
#include <gtest/gtest.h>

namespace {

constexpr int kUnknowns = 8;
constexpr double kTolerance = 1e-9;

using Equations = vo::NormalEquations<kUnknowns>;

/// Twenty residuals of random Jacobian and value, each of its own weight.
struct Problem {
  Eigen::Matrix<double, 20, kUnknowns> J = decltype(J)::Random();
  Eigen::Matrix<double, 20, 1> r = decltype(r)::Random();
  Eigen::Matrix<double, 20, 1> weight = decltype(weight)::Random().cwiseAbs();

  Equations equations() const {
    Equations result;
    for (int i = 0; i < 20; i += 2) {  // two at a time
      result.add_residuals(J.middleRows<2>(i), r.segment<2>(i), weight[i]);
    }
    return result;
  }

  /// The roots of the weights that equations() gives to the residuals.
  Eigen::Matrix<double, 20, 1> roots() const {
    Eigen::Matrix<double, 20, 1> result;
    for (int i = 0; i < 20; ++i) {
      result[i] = std::sqrt(weight[i - i % 2]);
    }
    return result;
  }

  /// The least-squares solution from the residuals themselves.
  Equations::Vector solution() const {
    const Eigen::MatrixXd weighted_jacobian = roots().asDiagonal() * J;
    const Eigen::VectorXd weighted_residuals = roots().cwiseProduct(r);
    const Eigen::VectorXd solution =
        weighted_jacobian.colPivHouseholderQr().solve(weighted_residuals);
    return -solution;
  }
};

TEST(NormalEquations, StepIsTheLeastSquaresSolution) {
  const Problem problem;
  EXPECT_LT((problem.equations().step() - problem.solution()).norm(), kTolerance);
}

TEST(NormalEquations, AResidualCountsAsMuchAloneAsAmongOthers) {
  const Problem problem;
  Equations alone;
  for (int i = 0; i < 20; ++i) {
    alone.add_residual(problem.J.row(i).transpose(), problem.r[i], problem.weight[i - i % 2]);
  }
  EXPECT_LT((alone.H - problem.equations().H).norm(), kTolerance);
  EXPECT_LT((alone.b - problem.equations().b).norm(), kTolerance);
}

template <int E>
void expect_elimination_to_solve_for_all(const Problem& problem) {
  const Equations all = problem.equations();
  const Equations::Vector expected = problem.solution();
  const auto kept = all.eliminated<E>();
  EXPECT_LT((kept.step() - expected.head<kUnknowns - E>()).norm(), kTolerance) << E;
  EXPECT_LT((all.eliminated_step<E>(kept.step()) - expected.tail<E>()).norm(), kTolerance) << E;
}

TEST(NormalEquations, EliminatingUnknownsSolvesForAll) {
  const Problem problem;
  expect_elimination_to_solve_for_all<2>(problem);  // by the inverse of a block
  expect_elimination_to_solve_for_all<6>(problem);  // by a decomposition
}

TEST(NormalEquations, EliminatedStepIsTheBestForAnyOtherStep) {
  const Equations all = Problem().equations();
  const Eigen::Matrix<double, 6, 1> others = decltype(others)::Random();
  Equations::Vector step;
  step << others, all.eliminated_step<2>(others);
  EXPECT_LT((all.H * step + all.b).tail<2>().norm(), kTolerance) << "no slope is left";
}

TEST(NormalEquations, LeadingAndTrailingUnknownsAreSolvedForWhileTheOthersStay) {
  const Equations all = Problem().equations();
  const auto leading = all.leading<3>();
  EXPECT_EQ(leading.H, (all.H.block<3, 3>(0, 0)));
  EXPECT_EQ(leading.b, all.b.segment<3>(0));
  const auto trailing = all.trailing<3>();
  EXPECT_EQ(trailing.H, (all.H.block<3, 3>(5, 5)));
  EXPECT_EQ(trailing.b, all.b.segment<3>(5));
}

/// Six unknowns move the eight linearly; the residuals' Jacobian by them is a product.
TEST(NormalEquations, OfOtherUnknownsFollowTheChainRule) {
  const Problem problem;
  const Eigen::Matrix<double, kUnknowns, 6> J = decltype(J)::Random();
  vo::NormalEquations<6> expected;
  for (int i = 0; i < 20; i += 2) {
    expected.add_residuals(problem.J.middleRows<2>(i) * J, problem.r.segment<2>(i),
                           3 * problem.weight[i]);
  }
  Equations of_eight = problem.equations();
  of_eight.cost = 5;
  vo::NormalEquations<6> fixed;
  fixed.add(of_eight, J, 3);
  auto dynamic = vo::NormalEquations<Eigen::Dynamic>::zero(6);
  dynamic.add(of_eight, J, 3);
  EXPECT_LT((fixed.H - expected.H).norm(), kTolerance);
  EXPECT_LT((fixed.b - expected.b).norm(), kTolerance);
  EXPECT_EQ(fixed.cost, 15);
  EXPECT_LT((dynamic.H - expected.H).norm(), kTolerance);
  EXPECT_LT((dynamic.b - expected.b).norm(), kTolerance);
  EXPECT_EQ(dynamic.cost, 15);
}

TEST(NormalEquations, AddUpInProportionToTheirWeights) {
  Equations sum = Problem().equations();
  Equations half = sum;
  half.cost = 4;
  sum.add(half, 0.5);
  EXPECT_LT((sum.H - 1.5 * half.H).norm(), kTolerance);
  EXPECT_LT((sum.b - 1.5 * half.b).norm(), kTolerance);
  EXPECT_EQ(sum.cost, 2);
}

TEST(SolveByColumns, SolvesForEachColumn) {
  const Equations::Matrix H = Problem().equations().H;
  const Eigen::Matrix<double, kUnknowns, 3> B = Eigen::Matrix<double, kUnknowns, 3>::Random();
  EXPECT_LT((H * vo::solve_by_columns<kUnknowns, 3>(H, B) - B).norm(), kTolerance);
}

TEST(SeparateUnknowns, StepSolvesTheirEquations) {
  const vo::SeparateUnknowns<> depths{Eigen::MatrixXd::Random(3, 5),
                                      Eigen::VectorXd::Random(5).cwiseAbs(),
                                      Eigen::VectorXd::Random(5)};
  const Eigen::Vector3d others(0.3, -0.5, 0.2);
  const Eigen::VectorXd step = depths.step_with(others);
  const Eigen::MatrixXd H = depths.H.asDiagonal();
  EXPECT_LT((depths.coupling.transpose() * others + H * step + depths.b).norm(), kTolerance);
}

}  // namespace
