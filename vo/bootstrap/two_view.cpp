#include "vo/bootstrap/two_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "vo/bootstrap/pair_terms.h"
#include "vo/core/damped_descent.h"
#include "vo/core/median.h"
#include "vo/core/normal_equations.h"

namespace vo {
namespace {

constexpr int kFirstIterations = 12;
constexpr int kLastIterations = 40;

double total_loss(const std::vector<RayPair>& pairs, const SE3& T, const std::vector<double>& d,
                  double scale) {
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    sum += pair_loss(pairs[i], T, d[i], scale);
  }
  return sum;
}

/// The normal equation of one inverse depth beside those of the pose.
struct DepthEquation {
  Vector6d coupling = Vector6d::Zero();
  double H = 1e-9;  ///< starts as the information of a weak prior
  double b = 0;

  double step_with(const Vector6d& pose_step) const { return -(b + coupling.dot(pose_step)) / H; }
};

/// The normal equations of the pose, depths eliminated, and what gives the depths' steps.
struct ReducedSystem {
  NormalEquations<6> pose;
  std::vector<DepthEquation> depths;
};

ReducedSystem reduced_system(const std::vector<RayPair>& pairs, const SE3& T,
                             const std::vector<double>& d, double scale) {
  ReducedSystem system{.depths = std::vector<DepthEquation>(pairs.size())};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairTerms terms = terms_of(pairs[i], T, d[i]);
    if (!terms.in_front) {
      continue;
    }
    const double w = cauchy_weight(terms.r.squaredNorm(), scale);
    DepthEquation& depth = system.depths[i];
    depth.coupling = w * terms.by_pose.transpose() * terms.by_depth;
    depth.H += w * terms.by_depth.squaredNorm();
    depth.b = w * terms.by_depth.dot(terms.r);
    NormalEquations<6> pose;
    pose.add_residuals(terms.by_pose, terms.r, w);
    system.pose.H += pose.H - depth.coupling * depth.coupling.transpose() / depth.H;
    system.pose.b += pose.b - depth.coupling * depth.b / depth.H;
  }
  return system;
}

/// Returns the step of the pose, keeping the length of the translation, which is undetermined.
Vector6d pose_step(const NormalEquations<6>& pose, const SE3& T, double damping) {
  NormalEquations<6> damped = pose;
  Vector6d along = Vector6d::Zero();
  along.head<3>() = T.translation().normalized();
  damped.H += pose.H.trace() * along * along.transpose();
  damped.H.diagonal() += damping * pose.H.diagonal();
  damped.H.diagonal().array() += 1e-12;
  return damped.step();
}

SE3 with_unit_translation(const SE3& T) {
  return {T.rotation(), T.translation().normalized()};
}

/// A motion and the inverse depths of the pairs under it.
struct MotionAndDepths {
  SE3 T;
  std::vector<double> d;
};

MotionAndDepths moved(const std::vector<RayPair>& pairs, const MotionAndDepths& from, double scale,
                      double damping) {
  const ReducedSystem system = reduced_system(pairs, from.T, from.d, scale);
  const Vector6d step = pose_step(system.pose, from.T, damping);
  MotionAndDepths next{with_unit_translation(SE3::exp(step) * from.T),
                       std::vector<double>(from.d.size())};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    double& d = next.d[i];
    d = from.d[i] + system.depths[i].step_with(step);
    if (!(d > 0 && std::abs(d) < 1e3)) {
      d = triangulate(pairs[i], next.T);
    }
  }
  return next;
}

/// Refines a motion and its inverse depths; returns the loss at the end.
double refine(const std::vector<RayPair>& pairs, double scale, int iterations,
              MotionAndDepths& start) {
  const auto step = [&](const MotionAndDepths& from, double damping) {
    return moved(pairs, from, scale, damping);
  };
  const auto loss = [&](const MotionAndDepths& at) { return total_loss(pairs, at.T, at.d, scale); };
  return descend(start, step, loss, {.iterations = iterations});
}

/// Returns a motion and the inverse depths that fit it best.
MotionAndDepths seen_under(const SE3& T, const std::vector<RayPair>& pairs) {
  MotionAndDepths result{T, {}};
  for (const RayPair& pair : pairs) {
    result.d.push_back(triangulate(pair, T));
  }
  return result;
}

TwoViewFit fit_of(const std::vector<RayPair>& pairs, MotionAndDepths found) {
  constexpr double kFarthest = 2e-3;
  TwoViewFit fit{.T_second_first = found.T, .inverse_depth = std::move(found.d)};
  std::vector<double> distances;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double d = fit.inverse_depth[i];
    const PairTerms terms = terms_of(pairs[i], fit.T_second_first, d);
    const bool valid = terms.in_front && d > kFarthest;
    fit.in_front += valid ? 1.0 / static_cast<double>(pairs.size()) : 0;
    distances.push_back(terms.in_front ? terms.r.norm() : 1);
  }
  fit.residual = upper_median(distances);
  return fit;
}

}  // namespace

RotationFit fit_rotation(const std::vector<RayPair>& pairs) {
  constexpr int kIterations = 15;
  RotationFit fit;
  for (int iteration = 0; iteration <= kIterations; ++iteration) {
    std::vector<double> distances;
    for (const RayPair& pair : pairs) {
      distances.push_back(terms_of(pair, fit.T_second_first, 0).r.norm());
    }
    fit.parallax = upper_median(distances);
    const double scale = std::max(1.5 * fit.parallax, 1e-5);
    NormalEquations<3> rotation{1e-12 * Eigen::Matrix3d::Identity()};
    for (const RayPair& pair : pairs) {
      const PairTerms terms = terms_of(pair, fit.T_second_first, 0);
      if (terms.in_front) {
        rotation.add_residuals(terms.by_pose.rightCols<3>(), terms.r,
                               cauchy_weight(terms.r.squaredNorm(), scale));
      }
    }
    Vector6d step = Vector6d::Zero();
    step.tail<3>() = rotation.step();
    if (iteration < kIterations) {
      fit.T_second_first = SE3::exp(step) * fit.T_second_first;
    }
  }
  return fit;
}

double triangulate(const RayPair& pair, const SE3& T_second_first) {
  constexpr double kFarthest = 1e-3;
  const Eigen::Vector3d a = T_second_first.rotation() * pair.first.homogeneous();
  const Eigen::Vector3d& t = T_second_first.translation();
  // Least squares of (a + d t) x second = 0 over its first two components.
  const Eigen::Vector2d at = a.head<2>() - pair.second * a.z();
  const Eigen::Vector2d slope = t.head<2>() - pair.second * t.z();
  const double norm2 = slope.squaredNorm();
  return norm2 > 0 ? std::max(-at.dot(slope) / norm2, kFarthest) : kFarthest;
}

TwoViewFit fit_two_views(const std::vector<RayPair>& pairs, const SE3& T_rotation,
                         double robust_scale) {
  MotionAndDepths found;
  double least = std::numeric_limits<double>::max();
  for (int code = 0; code < 27; ++code) {
    const Eigen::Vector3d direction =
        Eigen::Vector3i(code % 3, code / 3 % 3, code / 9).cast<double>() - Eigen::Vector3d::Ones();
    if (direction.isZero()) {
      continue;
    }
    MotionAndDepths start = seen_under({T_rotation.rotation(), direction.normalized()}, pairs);
    const double loss = refine(pairs, robust_scale, kFirstIterations, start);
    if (loss < least) {
      least = loss;
      found = std::move(start);
    }
  }
  refine(pairs, robust_scale, kLastIterations, found);
  return fit_of(pairs, std::move(found));
}

TwoViewFit refine_two_views(const std::vector<RayPair>& pairs, const SE3& T_guess,
                            double robust_scale) {
  MotionAndDepths found = seen_under(with_unit_translation(T_guess), pairs);
  refine(pairs, robust_scale, kLastIterations, found);
  return fit_of(pairs, std::move(found));
}

SE3 fit_pose(const std::vector<RayPair>& pairs, const std::vector<double>& inverse_depth,
             const SE3& T_second_first_guess, double robust_scale) {
  constexpr int kIterations = 12;
  SE3 T = T_second_first_guess;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    NormalEquations<6> pose{1e-12 * Matrix6d::Identity()};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const PairTerms terms = terms_of(pairs[i], T, inverse_depth[i]);
      if (terms.in_front) {
        pose.add_residuals(terms.by_pose, terms.r,
                           cauchy_weight(terms.r.squaredNorm(), robust_scale));
      }
    }
    T = SE3::exp(pose.step()) * T;
  }
  return T;
}

}  // namespace vo
