#include "vo/bootstrap/start_adjustment.h"

#include <Eigen/Cholesky>

#include "vo/bootstrap/pair_terms.h"
#include "vo/core/damped_descent.h"

namespace vo {
namespace {

constexpr Eigen::Index kPose = 6;

/// The normal equations of all poses and of each place's inverse depth.
struct System {
  Eigen::MatrixXd H;
  Eigen::VectorXd b;
  Eigen::MatrixXd coupling;  ///< one column for each place
  Eigen::VectorXd H_depth;
  Eigen::VectorXd b_depth;
};

System system_of(const StartViews& start, double scale) {
  constexpr double kDepthPrior = 1e-9;
  const auto poses = kPose * static_cast<Eigen::Index>(start.views.size());
  const auto places = static_cast<Eigen::Index>(start.inverse_depth.size());
  System system{Eigen::MatrixXd::Zero(poses, poses), Eigen::VectorXd::Zero(poses),
                Eigen::MatrixXd::Zero(poses, places),
                Eigen::VectorXd::Constant(places, kDepthPrior), Eigen::VectorXd::Zero(places)};
  for (std::size_t f = 0; f < start.views.size(); ++f) {
    const StartView& view = start.views[f];
    const Eigen::Index at = kPose * static_cast<Eigen::Index>(f);
    for (std::size_t k = 0; k < view.pairs.size(); ++k) {
      const auto place = static_cast<Eigen::Index>(view.places[k]);
      const PairTerms terms =
          terms_of(view.pairs[k], view.T_frame_first, start.inverse_depth[view.places[k]]);
      if (terms.in_front) {
        const double w = cauchy_weight(terms.r.squaredNorm(), scale);
        system.H.block<kPose, kPose>(at, at) += w * terms.by_pose.transpose() * terms.by_pose;
        system.b.segment<kPose>(at) += w * terms.by_pose.transpose() * terms.r;
        system.coupling.block<kPose, 1>(at, place) +=
            w * terms.by_pose.transpose() * terms.by_depth;
        system.H_depth[place] += w * terms.by_depth.squaredNorm();
        system.b_depth[place] += w * terms.by_depth.dot(terms.r);
      }
    }
  }
  return system;
}

/// Returns the damped step of all poses; the last translation keeps its length.
Eigen::VectorXd pose_step(const System& system, const SE3& T_last, double damping) {
  const Eigen::VectorXd inverse = system.H_depth.cwiseInverse();
  Eigen::MatrixXd H =
      system.H - system.coupling * inverse.asDiagonal() * system.coupling.transpose();
  const Eigen::VectorXd b = system.b - system.coupling * inverse.cwiseProduct(system.b_depth);
  const Eigen::Vector3d along = T_last.translation().normalized();
  H.diagonal() += damping * system.H.diagonal();
  H.diagonal().array() += 1e-12;
  H.block<3, 3>(H.rows() - kPose, H.cols() - kPose) += system.H.trace() * along * along.transpose();
  return -H.ldlt().solve(b);
}

/// Returns the start moved by a step of the poses, rescaled to the length of the last translation.
StartViews moved(const StartViews& start, const System& system, const Eigen::VectorXd& step) {
  StartViews next = start;
  for (std::size_t f = 0; f < next.views.size(); ++f) {
    SE3& T = next.views[f].T_frame_first;
    T = SE3::exp(step.segment<kPose>(kPose * static_cast<Eigen::Index>(f))) * T;
  }
  const double scale = next.views.back().T_frame_first.translation().norm() /
                       start.views.back().T_frame_first.translation().norm();
  const Eigen::VectorXd depth_step =
      -(system.b_depth + system.coupling.transpose() * step).cwiseQuotient(system.H_depth);
  for (std::size_t i = 0; i < next.inverse_depth.size(); ++i) {
    const double d = start.inverse_depth[i] + depth_step[static_cast<Eigen::Index>(i)];
    next.inverse_depth[i] = scale * (d > 0 ? d : start.inverse_depth[i]);
  }
  for (StartView& view : next.views) {
    view.T_frame_first = {view.T_frame_first.rotation(), view.T_frame_first.translation() / scale};
  }
  return next;
}

double loss_of(const StartViews& start, double scale) {
  double sum = 0;
  for (const StartView& view : start.views) {
    for (std::size_t k = 0; k < view.pairs.size(); ++k) {
      sum +=
          pair_loss(view.pairs[k], view.T_frame_first, start.inverse_depth[view.places[k]], scale);
    }
  }
  return sum;
}

}  // namespace

void adjust(StartViews& start, double robust_scale) {
  const auto step = [&](const StartViews& from, double damping) {
    const System system = system_of(from, robust_scale);
    return moved(from, system, pose_step(system, from.views.back().T_frame_first, damping));
  };
  const auto loss = [&](const StartViews& at) { return loss_of(at, robust_scale); };
  descend(start, step, loss, {.iterations = 25, .converged = 1e-6});
}

}  // namespace vo
