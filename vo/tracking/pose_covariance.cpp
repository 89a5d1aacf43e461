#include "vo/tracking/pose_covariance.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Cholesky>

namespace vo {
namespace {

constexpr double kBiasPx = 0.005;  // px, in u and in v
constexpr int kParameters = 6;

Vector6d total(const std::vector<Vector6d>& b) {
  return std::accumulate(b.begin(), b.end(), Vector6d(Vector6d::Zero()));
}

Matrix6d scatter(const std::vector<Vector6d>& b) {
  Matrix6d sum = Matrix6d::Zero();
  for (const Vector6d& cell : b) {
    sum += cell * cell.transpose();
  }
  return sum;
}

/// Too few cells do not tell how sure a reference is.
bool is_known(const std::vector<Vector6d>& b) {
  constexpr auto kMinCells = 4 * kParameters;
  return std::count_if(b.begin(), b.end(), [](const Vector6d& cell) { return !cell.isZero(0); }) >=
         kMinCells;
}

/// By how much the references disagree more than their cells explain, at least 1.
double birge_factor(const std::vector<CellScores>& references) {
  double chi2 = 0;
  int count = 0;
  for (const CellScores& reference : references) {
    if (is_known(reference.b())) {
      const Vector6d g = total(reference.b());
      chi2 += g.dot(scatter(reference.b()).ldlt().solve(g));
      ++count;
    }
  }
  return count > 1 ? std::max(1.0, chi2 / (kParameters * (count - 1))) : 1;
}

std::vector<Vector6d> sum_of(const std::vector<CellScores>& references) {
  std::vector<Vector6d> sum = references.front().b();
  for (std::size_t r = 1; r < references.size(); ++r) {
    for (std::size_t cell = 0; cell < sum.size(); ++cell) {
      sum[cell] += references[r].b()[cell];
    }
  }
  return sum;
}

/// Half the weighted sum of the squared gradients times the variance of a displacement. A rotation
/// about x or y moves pixels by about the focal length per rad, so H holds the sum.
double bias_variance(const Matrix6d& H, const PinholeCamera& camera) {
  const double squared_gradients =
      H(3, 3) / (camera.fy * camera.fy) + H(4, 4) / (camera.fx * camera.fx);
  return kBiasPx * kBiasPx * squared_gradients / 2;
}

/// By how much a pose moves when the velocities are off by what is in doubt, to first order.
Vector6d shift_by_doubts(JointProblem problem, const JointSystem& system, const SE3& T_cur_first,
                         double current, double references) {
  problem.set_doubts(current, references);
  return system.H.ldlt().solve(problem.linearize(T_cur_first).b - system.b);
}

/// Of the velocities that rows are moved with.
Matrix6d shutter_covariance(const JointProblem& problem, const JointSystem& system,
                            const SE3& T_cur_first) {
  if (problem.readout() == 0) {
    return Matrix6d::Zero();
  }
  const Vector6d by_current = shift_by_doubts(problem, system, T_cur_first, 1, 0);
  const Vector6d by_references = shift_by_doubts(problem, system, T_cur_first, 0, 1);
  return by_current * by_current.transpose() + by_references * by_references.transpose();
}

}  // namespace

Matrix6d sandwich_covariance(const JointProblem& problem, const JointSystem& system,
                             const SE3& T_cur_first) {
  constexpr double kMinCurvatureShare = 0.25;
  const JointScores scores = problem.scores(system, T_cur_first);
  const double share = std::max(scores.curvature_share, kMinCurvatureShare);
  const double factor = birge_factor(scores.references) / (share * share);
  const Matrix6d H_inverse = system.H.ldlt().solve(Matrix6d::Identity());
  const Matrix6d covariance = factor * H_inverse * scatter(sum_of(scores.references)) * H_inverse;
  return (covariance + covariance.transpose()) / 2;
}

Matrix6d pose_covariance(const JointProblem& problem, const JointSystem& system,
                         const SE3& T_cur_first) {
  const Matrix6d H_inverse = system.H.ldlt().solve(Matrix6d::Identity());
  return sandwich_covariance(problem, system, T_cur_first) +
         shutter_covariance(problem, system, T_cur_first) +
         bias_variance(system.H, problem.camera()) * (H_inverse + H_inverse.transpose()) / 2;
}

}  // namespace vo
