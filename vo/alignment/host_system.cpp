#include "vo/alignment/host_system.h"

#include <Eigen/Cholesky>

namespace vo {
namespace {

constexpr Eigen::Index kPose = 6;
constexpr Eigen::Index kBrightness = 2;

}  // namespace

HostSystem::HostSystem(const AlignOptions& options, std::size_t pairs, std::size_t points)
    : options_(options),
      pairs_(static_cast<Eigen::Index>(pairs)),
      H_pairs_(Eigen::MatrixXd::Zero(poses() + brightness(), poses() + brightness())),
      b_pairs_(Eigen::VectorXd::Zero(H_pairs_.rows())),
      coupling_(Eigen::MatrixXd::Zero(H_pairs_.rows(), static_cast<Eigen::Index>(points))),
      H_depth_(Eigen::VectorXd::Zero(coupling_.cols())),
      b_depth_(Eigen::VectorXd::Zero(coupling_.cols())) {}

void HostSystem::add(std::size_t k, const PointView& view, const ResidualModel& model) {
  const LinearSystem part = linearize(view, options_, model);
  const double inverse_variance = 1 / (model.scale * model.scale);
  const Eigen::Index pose = kPose * static_cast<Eigen::Index>(k);
  const Eigen::Index light = poses() + kBrightness * static_cast<Eigen::Index>(k);
  const Eigen::Matrix<double, kPose, kBrightness> coupling =
      inverse_variance * part.H.topRightCorner<kPose, kBrightness>();
  H_pairs_.block<kPose, kPose>(pose, pose) = inverse_variance * part.H_pose();
  H_pairs_.block<kPose, kBrightness>(pose, light) = coupling;
  H_pairs_.block<kBrightness, kPose>(light, pose) = coupling.transpose();
  H_pairs_.block<kBrightness, kBrightness>(light, light) = inverse_variance * part.H_brightness();
  b_pairs_.segment<kPose>(pose) = inverse_variance * part.b_pose();
  b_pairs_.segment<kBrightness>(light) = inverse_variance * part.b.tail<kBrightness>();
  if (coupling_.cols() > 0) {
    compute_point_terms(view, options_, model, scores_);
    add_depth(k, view, model.scale);
  }
}

/// Adds the derivatives by inverse depth d = 1 / z: p_cur = R_cur_ref ray / d + t, so d p_cur / d d
/// = -z R p_ref. The change of the rows' motion with depth is left out.
void HostSystem::add_depth(std::size_t k, const PointView& view, double scale) {
  const EdgePointLevel& points = view.points;
  const Eigen::Matrix3d R = view.T_cur_ref.rotation_matrix();
  const Eigen::Index pose = kPose * static_cast<Eigen::Index>(k);
  const Eigen::Index light = poses() + kBrightness * static_cast<Eigen::Index>(k);
  const double coupled = options_.brightness == BrightnessModel::affine ? 1 : 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const double w = scores_.weight[i] / (scale * scale);
    if (!(w > 0)) {
      continue;
    }
    Vector8d J;
    for (std::size_t p = 0; p < kPassParameters; ++p) {
      J[static_cast<Eigen::Index>(p)] = scores_.J[p][i];
    }
    const Eigen::Vector3d p_ref(points.x_ref[i], points.y_ref[i], points.z_ref[i]);
    const double by_depth = -p_ref.z() * J.head<3>().dot(R * p_ref);
    coupling_.col(column).segment<kPose>(pose) = w * by_depth * J.head<kPose>();
    coupling_.col(column).segment<kBrightness>(light) =
        coupled * w * by_depth * J.tail<kBrightness>();
    H_depth_[column] += w * by_depth * by_depth;
    b_depth_[column] += w * by_depth * scores_.residual[i];
  }
}

void HostSystem::hold_depth(const Eigen::VectorXd& information, const Eigen::VectorXd& strayed) {
  H_depth_ += information;
  b_depth_ += information.cwiseProduct(strayed);
  const Eigen::MatrixXd scaled = coupling_ * H_depth_.cwiseSqrt().cwiseInverse().asDiagonal();
  H_pairs_.selfadjointView<Eigen::Lower>().rankUpdate(scaled, -1);
  H_pairs_ = Eigen::MatrixXd(H_pairs_.selfadjointView<Eigen::Lower>());
  b_pairs_ -= coupling_ * b_depth_.cwiseQuotient(H_depth_);
}

Eigen::MatrixXd HostSystem::brightness_gain() const {
  return -H_pairs_.bottomRightCorner(brightness(), brightness())
              .ldlt()
              .solve(H_pairs_.bottomLeftCorner(brightness(), poses()));
}

HostSystem::Increments HostSystem::increments() const {
  const Eigen::MatrixXd gain = brightness_gain();
  return {H_pairs_.topLeftCorner(poses(), poses()) +
              H_pairs_.topRightCorner(poses(), brightness()) * gain,
          b_pairs_.head(poses()) + gain.transpose() * b_pairs_.tail(brightness())};
}

HostSystem::Step HostSystem::step_with(const Eigen::VectorXd& increments) const {
  const Eigen::VectorXd by_light = b_pairs_.tail(brightness());
  Eigen::VectorXd all(H_pairs_.rows());
  all << increments,
      brightness_gain() * increments -
          H_pairs_.bottomRightCorner(brightness(), brightness()).ldlt().solve(by_light);
  const Eigen::VectorXd inverse_depth =
      -(b_depth_ + coupling_.transpose() * all).cwiseQuotient(H_depth_);
  return {all.tail(brightness()), inverse_depth};
}

}  // namespace vo
