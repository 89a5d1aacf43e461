#include "vo/tracking/align.h"

#include <cassert>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "vo/core/error.h"

namespace vo {
namespace {

/// Below this ratio of the eigenvalues of the scaled H, a direction is noise: the surface and its
/// texture do not determine it.
constexpr double kMinConditioning = 1e-8;

constexpr int kDegreesOfFreedom = 6;

double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

/// Scales translation and rotation to the same size before judging the eigenvalues.
bool is_singular(const Matrix6d& H) {
  const Vector6d diagonal = H.diagonal();
  if (!(diagonal.minCoeff() > 0)) {
    return true;
  }
  const Vector6d scale = diagonal.cwiseSqrt().cwiseInverse();
  const Matrix6d scaled = scale.asDiagonal() * H * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(scaled, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() < kMinConditioning * solver.eigenvalues().maxCoeff();
}

bool is_small(const Vector6d& delta, const AlignOptions& options) {
  return delta.head<3>().norm() < options.min_translation &&
         degrees(delta.tail<3>().norm()) < options.min_rotation_deg;
}

/// One pyramid level: improves `result.T_cur_ref` and returns the system at the final pose.
LinearSystem align_level(const EdgePointLevel& reference, const PyramidLevel& current,
                         const AlignOptions& options, AlignResult& result) {
  const auto min_points = static_cast<std::size_t>(options.min_points);
  LinearSystem system = linearize(reference, current, result.T_cur_ref, options);
  result.termination = Termination::max_iterations;
  for (int i = 0; i < options.max_iterations && system.points >= min_points; ++i) {
    if (is_singular(system.H)) {
      result.termination = Termination::singular;
      break;
    }
    const Vector6d delta = -system.H.ldlt().solve(system.b);
    if (is_small(delta, options)) {
      result.termination = Termination::converged;
      break;
    }
    const SE3 T_candidate = SE3::exp(delta) * result.T_cur_ref;
    const LinearSystem candidate = linearize(reference, current, T_candidate, options);
    ++result.iterations;
    if (!(candidate.cost < system.cost)) {
      result.termination = Termination::no_better_step;
      break;
    }
    result.T_cur_ref = T_candidate;
    system = candidate;
  }
  if (system.points < min_points) {
    result.termination = Termination::too_few_points;
  }
  return system;
}

/// s^2 H^-1 with s^2 the weighted variance of the residuals: the covariance of least squares. Pixel
/// errors are correlated, so it is a lower bound.
Matrix6d covariance_of(const LinearSystem& system) {
  const double freedom = static_cast<double>(system.points) - kDegreesOfFreedom;
  return system.squared_residuals / freedom * system.H.ldlt().solve(Matrix6d::Identity());
}

void summarize(const LinearSystem& system, std::size_t total, AlignResult& result) {
  result.points = system.points;
  result.cost = system.cost;
  if (system.points > 0) {
    result.visible_fraction = static_cast<double>(system.points) / static_cast<double>(total);
  }
  if (result.usable()) {
    result.covariance = covariance_of(system);
  }
}

}  // namespace

void AlignOptions::validate() const {
  require(max_iterations >= 1, "align.max_iterations: expected at least 1, got ", max_iterations);
  require(min_translation >= 0 && min_rotation_deg >= 0,
          "align: expected step limits of at least 0");
  require(loss_scale > 0, "align.loss_scale: expected above 0, got ", loss_scale);
  require(min_points > kDegreesOfFreedom, "align.min_points: expected more than ",
          kDegreesOfFreedom, ", got ", min_points);
}

AlignResult align(const EdgePoints& reference, const FramePyramid& current,
                  const SE3& T_cur_ref_guess, const AlignOptions& options) {
  assert(reference.levels.size() == current.levels.size());
  AlignResult result;
  result.T_cur_ref = T_cur_ref_guess;
  for (std::size_t l = reference.levels.size(); l-- > 0;) {
    const LinearSystem system =
        align_level(reference.levels[l], current.levels[l], options, result);
    if (l == 0) {
      summarize(system, reference.levels[l].size(), result);
      result.correlation = correlation(reference.levels[l], current.levels[l], result.T_cur_ref);
    }
  }
  return result;
}

}  // namespace vo
