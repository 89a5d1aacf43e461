#include "vo/alignment/pose_covariance.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Cholesky>

namespace vo {
namespace {

constexpr double kBiasPx = 0.005;       // px, in u and in v
constexpr double kExposureShare = 0.7;  // of the read-out time, that lines are exposed for
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

/// Returns whether enough cells have points to tell how certain a reference is.
bool is_known(const std::vector<Vector6d>& b) {
  constexpr auto kMinCells = 4 * kParameters;
  return std::count_if(b.begin(), b.end(), [](const Vector6d& cell) { return !cell.isZero(0); }) >=
         kMinCells;
}

/// Returns how much more the references disagree than their cells explain, at least 1.
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

/// Returns the scatter of the cells, each summed over the references.
Matrix6d joint_scatter(const std::vector<CellScores>& references) {
  Matrix6d sum = Matrix6d::Zero();
  for (std::size_t cell = 0; cell < references.front().b().size(); ++cell) {
    Vector6d b = Vector6d::Zero();
    for (const CellScores& reference : references) {
      b += reference.b()[cell];
    }
    sum += b * b.transpose();
  }
  return sum;
}

/// Returns half the weighted sum of the squared gradients times a displacement's variance. H holds
/// that sum, as a rotation about x or y moves pixels by about the focal length per radian.
double bias_variance(const Matrix6d& H, const PinholeCamera& camera) {
  const double squared_gradients =
      H(3, 3) / (camera.fy * camera.fy) + H(4, 4) / (camera.fx * camera.fx);
  return kBiasPx * kBiasPx * squared_gradients / 2;
}

/// Returns the covariance of a twist whose linear and angular part are as large as these, each in
/// any direction.
Matrix6d in_any_direction(const Vector6d& twist) {
  Vector6d variance;
  variance.head<3>().setConstant(twist.head<3>().squaredNorm() / 3);
  variance.tail<3>().setConstant(twist.tail<3>().squaredNorm() / 3);
  return variance.asDiagonal();
}

/// Returns the covariance of b that the velocities' doubt causes through the rolling shutter.
Matrix6d shutter_scatter(const JointProblem& problem, const JointScores& scores,
                         const SE3& T_cur_first) {
  const Matrix6d& K = scores.by_current_velocity;
  Matrix6d sum = K * in_any_direction(problem.current_velocity(T_cur_first).doubt) * K.transpose();
  for (std::size_t r = 0; r < scores.by_reference_velocity.size(); ++r) {
    const Matrix6d& K_ref = scores.by_reference_velocity[r];
    sum += K_ref * in_any_direction(problem.reference_velocity(r).doubt) * K_ref.transpose();
  }
  return sum;
}

/// Returns the covariance of the increment by which accelerations move the mean of an image, of the
/// current frame and of the first reference.
Matrix6d acceleration_covariance(const JointProblem& problem, const SE3& T_cur_first) {
  const double readout = problem.options().readout.seconds;
  const double exposure = kExposureShare * readout;
  const double seconds2 = (readout * readout + exposure * exposure) / 24;
  const Matrix6d J = adjoint(T_cur_first);
  const Matrix6d squared_accelerations =
      in_any_direction(problem.current_velocity(T_cur_first).acceleration) +
      J * in_any_direction(problem.reference_velocity(0).acceleration) * J.transpose();
  return seconds2 * seconds2 * squared_accelerations;
}

/// Returns H^-1 S H^-1, the covariance of the increment that follows from the covariance S of b.
Matrix6d propagated(const Matrix6d& H_inverse, const Matrix6d& scatter_of_b) {
  const Matrix6d covariance = H_inverse * scatter_of_b * H_inverse;
  return (covariance + covariance.transpose()) / 2;
}

/// Returns the covariance that comes from what differs from cell to cell.
Matrix6d cell_covariance(const JointScores& scores, const Matrix6d& H_inverse) {
  constexpr double kMinCurvatureShare = 0.25;
  const double share = std::max(scores.curvature_share, kMinCurvatureShare);
  const double factor = birge_factor(scores.references) / (share * share);
  return factor * propagated(H_inverse, joint_scatter(scores.references));
}

}  // namespace

Matrix6d sandwich_covariance(const JointProblem& problem, const JointSystem& system,
                             const SE3& T_cur_first) {
  AlignMemory memory;
  const JointScores& scores = problem.scores(system, T_cur_first, memory);
  return cell_covariance(scores, NoiseFreeCurvature(system.H, scores.noise_curvature).inverse());
}

Matrix6d pose_covariance(const JointProblem& problem, const JointSystem& system,
                         const JointScores& scores, const NoiseFreeCurvature& curvature,
                         const SE3& T_cur_first) {
  const Matrix6d H_inverse = curvature.inverse();
  return cell_covariance(scores, H_inverse) +
         propagated(H_inverse, shutter_scatter(problem, scores, T_cur_first)) +
         acceleration_covariance(problem, T_cur_first) +
         bias_variance(system.H, problem.camera()) * (H_inverse + H_inverse.transpose()) / 2;
}

}  // namespace vo
