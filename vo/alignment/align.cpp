#include "vo/alignment/align.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include <Eigen/Eigenvalues>

#include "vo/alignment/pose_covariance.h"
#include "vo/alignment/secant_hessian.h"
#include "vo/core/error.h"

namespace vo {
namespace {

/// Least ratio of the eigenvalues of the scaled H. Below it a direction of motion is noise: the
/// surface and its texture do not determine it.
constexpr double kMinConditioning = 1e-8;

constexpr int kDegreesOfFreedom = 6;

double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

/// Returns the least over the greatest eigenvalue of H, translation and rotation scaled to the same
/// size, or 0 where a parameter has no influence at all.
double conditioning_of(const Matrix6d& H) {
  const Vector6d diagonal = H.diagonal();
  if (!(diagonal.minCoeff() > 0)) {
    return 0;
  }
  const Vector6d scale = diagonal.cwiseSqrt().cwiseInverse();
  const Matrix6d scaled = scale.asDiagonal() * H * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(scaled, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() / solver.eigenvalues().maxCoeff();
}

/// Returns whether a step is below this many times its limits on a level.
bool is_small(const Vector6d& delta, double times, std::size_t level, const AlignOptions& options) {
  const double factor = times * std::pow(options.step_limit_growth, static_cast<double>(level));
  return delta.head<3>().norm() < factor * options.min_translation &&
         degrees(delta.tail<3>().norm()) < factor * options.min_rotation_deg;
}

/// Gauss-Newton on one pyramid level.
class LevelAlignment {
 public:
  LevelAlignment(JointProblem& problem, AlignResult& result)
      : problem_(problem), options_(problem.options()), result_(result) {}

  /// Improves the result's pose and returns the system there.
  const JointSystem& run() {
    const auto min_points = static_cast<std::size_t>(options_.min_points);
    system_ = problem_.linearize(result_.T_cur_ref);
    result_.termination = Termination::max_iterations;
    for (int i = 0; i < options_.max_iterations && system_.points >= min_points; ++i) {
      if (!(conditioning_of(system_.H) >= kMinConditioning)) {
        result_.termination = Termination::singular;
        break;
      }
      if (!step()) {
        break;
      }
    }
    if (system_.points < min_points) {
      result_.termination = Termination::too_few_points;
    }
    return system_;
  }

 private:
  /// Returns whether steps show the curvature of the loss. Far from the minimum, where coarse
  /// levels start, the loss is not convex and a secant leads astray.
  bool learns_curvature() const { return options_.secant && problem_.level() == 0; }

  /// Returns the step that minimises the loss as far as its curvature is known.
  Vector6d next_step() const {
    return NormalEquations<6>{hessian_.corrected(system_.H), system_.b}.step();
  }

  /// Takes a step and returns true, or says in the result why there is none and returns false.
  bool step() {
    const Vector6d delta = next_step();
    if (is_small(delta, options_.last_step, problem_.level(), options_)) {
      if (!is_small(delta, 1, problem_.level(), options_)) {
        take_unchecked(delta);
      }
      result_.termination = Termination::converged;
      return false;
    }
    if (accept(delta)) {
      return true;
    }
    result_.termination = Termination::no_better_step;
    return false;
  }

  void take_unchecked(const Vector6d& delta) {
    problem_.update_brightness(system_, delta, result_.T_cur_ref);
    problem_.advance(system_, delta, result_.T_cur_ref);
    result_.T_cur_ref = SE3::exp(delta) * result_.T_cur_ref;
  }

  /// Moves by the increment unless the cost would rise; returns whether the cost fell.
  bool accept(const Vector6d& delta) {
    const JointProblem::Models models = problem_.models();
    const SE3 T_candidate = SE3::exp(delta) * result_.T_cur_ref;
    problem_.update_brightness(system_, delta, result_.T_cur_ref);
    const JointSystem candidate = problem_.linearize(T_candidate);
    ++result_.iterations;
    const bool better = candidate.cost < system_.cost;
    if (!better && !options_.keep_worse_step) {
      problem_.set_models(models);
      return false;
    }
    result_.T_cur_ref = T_candidate;
    if (learns_curvature()) {
      hessian_.add(delta, candidate.b - system_.b);
    }
    system_ = candidate;
    return better;
  }

  JointProblem& problem_;
  const AlignOptions& options_;
  AlignResult& result_;
  JointSystem system_;
  SecantHessian hessian_;
};

double mean_depth(const EdgePointLevel& points) {
  const double sum = std::accumulate(points.z_ref.begin(), points.z_ref.end(), 0.0);
  return points.size() > 0 ? sum / static_cast<double>(points.size()) : 0;
}

void summarize(const JointSystem& system, const JointProblem& problem, AlignMemory& memory,
               AlignResult& result) {
  const PointEquations& first = system.parts.front();
  result.points = system.points;
  result.cost = system.cost;
  result.gain = problem.models().front().brightness.gain;
  result.offset = problem.models().front().brightness.offset;
  result.models = problem.models();
  result.conditioning = conditioning_of(system.H);
  if (first.total > 0) {
    result.visible_fraction = static_cast<double>(first.points) / static_cast<double>(first.total);
  }
  if (result.usable()) {
    const JointScores& scores = problem.scores(system, result.T_cur_ref, memory);
    const NoiseFreeCurvature curvature(system.H, scores.noise_curvature);
    result.noise_share = curvature.noise_share();
    result.covariance = pose_covariance(problem, system, scores, curvature, result.T_cur_ref);
    result.loss_by_readout = scores.loss_by_readout;
    result.agreement = scores.agreement;
  }
  const PointView seen = problem.forward_view(0, result.T_cur_ref);
  result.mean_depth = mean_depth(seen.points);
  result.correlation = correlation(seen);
  result.depth_agreement = problem.depth_agreement(result.T_cur_ref);
}

/// Returns the references that are aligned to on a level.
std::span<const AlignReference> references_of(std::size_t level,
                                              std::span<const AlignReference> references,
                                              const AlignOptions& options) {
  const auto most = static_cast<std::size_t>(options.coarse_references);
  const bool all = level == 0 || most == 0;
  return all ? references : references.first(std::min(most, references.size()));
}

}  // namespace

void AlignOptions::validate() const {
  constexpr int kMostThreads = 1024;
  require(max_iterations >= 1, "align.max_iterations: expected at least 1, got ", max_iterations);
  require(min_translation >= 0 && min_rotation_deg >= 0,
          "align: expected step limits of at least 0");
  require(step_limit_growth >= 1, "align.step_limit_growth: expected at least 1, got ",
          step_limit_growth);
  require(last_step >= 1, "align.last_step: expected at least 1, got ", last_step);
  require(coarse_references >= 0, "align.coarse_references: expected at least 0, got ",
          coarse_references);
  require(threads >= 1 && threads <= kMostThreads, "align.threads: expected 1 to ", kMostThreads,
          ", got ", threads);
  require(depth_term >= 0, "align.depth_term: expected at least 0, got ", depth_term);
  require(depth_noise >= 0, "align.depth_noise: expected at least 0, got ", depth_noise);
  require(max_depth_ratio == 0 || max_depth_ratio > 1,
          "align.max_depth_ratio: expected 0 or above 1, got ", max_depth_ratio);
  require(std::abs(readout.seconds) <= kMaxReadout, "align.readout: expected ", -kMaxReadout,
          " to ", kMaxReadout, " s, got ", readout.seconds);
  require(loss_scale > 0, "align.loss_scale: expected above 0, got ", loss_scale);
  require(min_points > kDegreesOfFreedom, "align.min_points: expected more than ",
          kDegreesOfFreedom, ", got ", min_points);
}

AlignResult align(std::span<const AlignReference> references, const AlignCurrent& current,
                  const SE3& T_cur_ref_guess, const AlignOptions& options) {
  AlignMemory memory;
  return align(references, current, T_cur_ref_guess, options, memory);
}

AlignResult align(std::span<const AlignReference> references, const AlignCurrent& current,
                  const SE3& T_cur_ref_guess, const AlignOptions& options, AlignMemory& memory) {
  AlignResult result;
  result.T_cur_ref = T_cur_ref_guess;
  std::optional<JointProblem> coarser;
  for (std::size_t l = current.frame.levels.size(); l-- > 0;) {
    JointProblem problem(references_of(l, references, options), current, l, options);
    if (coarser) {
      problem.start_from(*coarser, result.T_cur_ref);
    } else {
      problem.match_brightness(result.T_cur_ref);
    }
    problem.estimate_scales(result.T_cur_ref);
    LevelAlignment alignment(problem, result);
    const JointSystem& system = alignment.run();
    if (l == 0) {
      summarize(system, problem, memory, result);
    }
    coarser.emplace(std::move(problem));
  }
  return result;
}

AlignResult align(const EdgePoints& reference, const FramePyramid& current,
                  const SE3& T_cur_ref_guess, const AlignOptions& options) {
  assert(reference.levels.size() == current.levels.size());
  const std::array references{AlignReference{reference, SE3()}};
  return align(references, AlignCurrent{current}, T_cur_ref_guess, options);
}

}  // namespace vo
