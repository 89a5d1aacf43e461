#include "vo/bootstrap/start_adjustment.h"

#include "vo/bootstrap/pair_terms.h"
#include "vo/core/damped_descent.h"
#include "vo/core/normal_equations.h"

namespace vo {
namespace {

constexpr Eigen::Index kPose = 6;

/// The standard deviation of read-out times, s, before anything is known.
constexpr double kReadoutSigma = 0.03;

/// Errors of a corner are alike from frame to frame: four pairs are worth one.
constexpr double kDependence = 4;

/// The normal equations of all poses, then the read-out time, and of each place's inverse depth.
struct System {
  NormalEquations<Eigen::Dynamic> motion;
  SeparateUnknowns<> depths;
};

/// Adds the terms of the read-out time, whose derivative of a pair's residual is `bend`.
void add_readout(const PairTerms& terms, const Eigen::Vector2d& bend, double w, Eigen::Index view,
                 Eigen::Index place, System& system) {
  auto& [motion, depths] = system;
  const Eigen::Index last = motion.b.size() - 1;
  const Eigen::Matrix<double, kPose, 1> mixed = w * terms.by_pose.transpose() * bend;
  motion.H.block<kPose, 1>(view, last) += mixed;
  motion.H.block<1, kPose>(last, view) += mixed.transpose();
  motion.H(last, last) += w * bend.squaredNorm();
  motion.b[last] += w * bend.dot(terms.r);
  depths.coupling(last, place) += w * bend.dot(terms.by_depth);
}

/// Returns the information of a read-out time of 0 before any pair is seen.
double readout_prior(double scale) {
  return kDependence * scale * scale / (kReadoutSigma * kReadoutSigma);
}

System system_of(const StartViews& start, double scale) {
  constexpr double kDepthPrior = 1e-9;
  const auto unknowns = kPose * static_cast<Eigen::Index>(start.views.size()) + 1;
  const auto places = static_cast<Eigen::Index>(start.inverse_depth.size());
  System system{NormalEquations<Eigen::Dynamic>::zero(unknowns),
                {Eigen::MatrixXd::Zero(unknowns, places),
                 Eigen::VectorXd::Constant(places, kDepthPrior), Eigen::VectorXd::Zero(places)}};
  for (std::size_t f = 0; f < start.views.size(); ++f) {
    const StartView& view = start.views[f];
    const Eigen::Index at = kPose * static_cast<Eigen::Index>(f);
    NormalEquations<kPose> pose;
    for (std::size_t k = 0; k < view.pairs.size(); ++k) {
      const auto place = static_cast<Eigen::Index>(view.places[k]);
      const PairTerms terms = terms_of(view.unbent(k, start.readout.seconds), view.T_frame_first,
                                       start.inverse_depth[view.places[k]]);
      if (terms.in_front) {
        const double w = cauchy_weight(terms.r.squaredNorm(), scale);
        pose.add_residuals(terms.by_pose, terms.r, w);
        system.depths.coupling.block<kPose, 1>(at, place) +=
            w * terms.by_pose.transpose() * terms.by_depth;
        system.depths.H[place] += w * terms.by_depth.squaredNorm();
        system.depths.b[place] += w * terms.by_depth.dot(terms.r);
        add_readout(terms, view.bend[k], w, at, place, system);
      }
    }
    system.motion.H.block<kPose, kPose>(at, at) = pose.H;
    system.motion.b.segment<kPose>(at) = pose.b;
  }
  system.motion.H(unknowns - 1, unknowns - 1) += readout_prior(scale);
  system.motion.b[unknowns - 1] += readout_prior(scale) * start.readout.seconds;
  return system;
}

/// Returns the damped step of all poses and the read-out time; the last translation keeps its
/// length, and a known read-out time its value.
Eigen::VectorXd motion_step(const System& system, const StartViews& start, double damping) {
  constexpr double kHeld = 1e12;
  const auto& [motion, depths] = system;
  const Eigen::VectorXd inverse = depths.H.cwiseInverse();
  NormalEquations<Eigen::Dynamic> reduced{
      motion.H - depths.coupling * inverse.asDiagonal() * depths.coupling.transpose(),
      motion.b - depths.coupling * inverse.cwiseProduct(depths.b)};
  const Eigen::Vector3d along = start.views.back().T_frame_first.translation().normalized();
  reduced.H.diagonal() += damping * motion.H.diagonal();
  reduced.H.diagonal().array() += 1e-12;
  const Eigen::Index poses = motion.b.size() - 1;
  reduced.H.block<3, 3>(poses - kPose, poses - kPose) +=
      motion.H.topLeftCorner(poses, poses).trace() * along * along.transpose();
  reduced.H(poses, poses) *= start.readout_is_known ? kHeld : 1;
  return reduced.step();
}

/// Returns the start moved by a step of the poses, rescaled to the length of the last translation.
StartViews moved(const StartViews& start, const System& system, const Eigen::VectorXd& step) {
  StartViews next = start;
  for (std::size_t f = 0; f < next.views.size(); ++f) {
    SE3& T = next.views[f].T_frame_first;
    T = SE3::exp(step.segment<kPose>(kPose * static_cast<Eigen::Index>(f))) * T;
  }
  next.readout.seconds += start.readout_is_known ? 0 : step[step.size() - 1];
  const double scale = next.views.back().T_frame_first.translation().norm() /
                       start.views.back().T_frame_first.translation().norm();
  const Eigen::VectorXd depth_step = system.depths.step_with(step);
  for (std::size_t i = 0; i < next.inverse_depth.size(); ++i) {
    const double d = start.inverse_depth[i] + depth_step[static_cast<Eigen::Index>(i)];
    next.inverse_depth[i] = scale * (d > 0 ? d : start.inverse_depth[i]);
  }
  for (StartView& view : next.views) {
    view.T_frame_first = {view.T_frame_first.rotation(), view.T_frame_first.translation() / scale};
  }
  return next;
}

}  // namespace

RayPair StartView::unbent(std::size_t pair, double readout_s) const {
  RayPair result = pairs[pair];
  result.second -= readout_s * bend[pair];
  return result;
}

double loss_of(const StartViews& start, double robust_scale) {
  double sum = readout_prior(robust_scale) * start.readout.seconds * start.readout.seconds;
  for (const StartView& view : start.views) {
    for (std::size_t k = 0; k < view.pairs.size(); ++k) {
      sum += pair_loss(view.unbent(k, start.readout.seconds), view.T_frame_first,
                       start.inverse_depth[view.places[k]], robust_scale);
    }
  }
  return sum;
}

void adjust(StartViews& start, double robust_scale) {
  const auto step = [&](const StartViews& from, double damping) {
    const System system = system_of(from, robust_scale);
    return moved(from, system, motion_step(system, from, damping));
  };
  const auto loss = [&](const StartViews& at) { return loss_of(at, robust_scale); };
  descend(start, step, loss, {.iterations = 25, .converged = 1e-6});
}

}  // namespace vo
