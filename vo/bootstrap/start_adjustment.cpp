#include "vo/bootstrap/start_adjustment.h"

#include "vo/bootstrap/pair_terms.h"
#include "vo/core/damped_descent.h"
#include "vo/core/normal_equations.h"

namespace vo {
namespace {

constexpr Eigen::Index kPose = 6;

/// The normal equations of all poses and of each place's inverse depth.
struct System {
  NormalEquations<Eigen::Dynamic> poses;
  SeparateUnknowns<> depths;
};

System system_of(const StartViews& start, double scale) {
  constexpr double kDepthPrior = 1e-9;
  const auto poses = kPose * static_cast<Eigen::Index>(start.views.size());
  const auto places = static_cast<Eigen::Index>(start.inverse_depth.size());
  System system{NormalEquations<Eigen::Dynamic>::zero(poses),
                {Eigen::MatrixXd::Zero(poses, places),
                 Eigen::VectorXd::Constant(places, kDepthPrior), Eigen::VectorXd::Zero(places)}};
  for (std::size_t f = 0; f < start.views.size(); ++f) {
    const StartView& view = start.views[f];
    const Eigen::Index at = kPose * static_cast<Eigen::Index>(f);
    NormalEquations<kPose> pose;
    for (std::size_t k = 0; k < view.pairs.size(); ++k) {
      const auto place = static_cast<Eigen::Index>(view.places[k]);
      const PairTerms terms =
          terms_of(view.pairs[k], view.T_frame_first, start.inverse_depth[view.places[k]]);
      if (terms.in_front) {
        const double w = cauchy_weight(terms.r.squaredNorm(), scale);
        pose.add_residuals(terms.by_pose, terms.r, w);
        system.depths.coupling.block<kPose, 1>(at, place) +=
            w * terms.by_pose.transpose() * terms.by_depth;
        system.depths.H[place] += w * terms.by_depth.squaredNorm();
        system.depths.b[place] += w * terms.by_depth.dot(terms.r);
      }
    }
    system.poses.H.block<kPose, kPose>(at, at) = pose.H;
    system.poses.b.segment<kPose>(at) = pose.b;
  }
  return system;
}

/// Returns the damped step of all poses; the last translation keeps its length.
Eigen::VectorXd pose_step(const System& system, const SE3& T_last, double damping) {
  const auto& [poses, depths] = system;
  const Eigen::VectorXd inverse = depths.H.cwiseInverse();
  NormalEquations<Eigen::Dynamic> reduced{
      poses.H - depths.coupling * inverse.asDiagonal() * depths.coupling.transpose(),
      poses.b - depths.coupling * inverse.cwiseProduct(depths.b)};
  const Eigen::Vector3d along = T_last.translation().normalized();
  reduced.H.diagonal() += damping * poses.H.diagonal();
  reduced.H.diagonal().array() += 1e-12;
  reduced.H.bottomRightCorner<kPose, kPose>().topLeftCorner<3, 3>() +=
      poses.H.trace() * along * along.transpose();
  return reduced.step();
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
