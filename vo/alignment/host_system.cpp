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
      equations_(NormalEquations<Eigen::Dynamic>::zero(poses() + brightness())) {
  const auto depths = static_cast<Eigen::Index>(points);
  depths_ = {Eigen::MatrixXd::Zero(equations_.b.size(), depths), Eigen::VectorXd::Zero(depths),
             Eigen::VectorXd::Zero(depths)};
}

void HostSystem::add(std::size_t k, const PointView& view, const ResidualModel& model) {
  NormalEquations<kPassParameters> part;
  part.add(linearize(view, options_, model), 1 / (model.scale * model.scale));
  const Eigen::Index pose = kPose * static_cast<Eigen::Index>(k);
  const Eigen::Index light = poses() + kBrightness * static_cast<Eigen::Index>(k);
  Eigen::MatrixXd& H = equations_.H;
  H.block<kPose, kPose>(pose, pose) = part.H.topLeftCorner<kPose, kPose>();
  H.block<kPose, kBrightness>(pose, light) = part.H.topRightCorner<kPose, kBrightness>();
  H.block<kBrightness, kPose>(light, pose) = part.H.bottomLeftCorner<kBrightness, kPose>();
  H.block<kBrightness, kBrightness>(light, light) =
      part.H.bottomRightCorner<kBrightness, kBrightness>();
  equations_.b.segment<kPose>(pose) = part.b.head<kPose>();
  equations_.b.segment<kBrightness>(light) = part.b.tail<kBrightness>();
  if (depths_.b.size() > 0) {
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
    PointEquations::Vector J;
    for (std::size_t p = 0; p < kPassParameters; ++p) {
      J[static_cast<Eigen::Index>(p)] = scores_.J[p][i];
    }
    const Eigen::Vector3d p_ref(points.x_ref[i], points.y_ref[i], points.z_ref[i]);
    const double by_depth = -p_ref.z() * J.head<3>().dot(R * p_ref);
    depths_.coupling.col(column).segment<kPose>(pose) = w * by_depth * J.head<kPose>();
    depths_.coupling.col(column).segment<kBrightness>(light) =
        coupled * w * by_depth * J.tail<kBrightness>();
    depths_.H[column] += w * by_depth * by_depth;
    depths_.b[column] += w * by_depth * scores_.residual[i];
  }
}

void HostSystem::hold_depth(const Eigen::VectorXd& information, const Eigen::VectorXd& strayed) {
  depths_.H += information;
  depths_.b += information.cwiseProduct(strayed);
  const Eigen::MatrixXd scaled =
      depths_.coupling * depths_.H.cwiseSqrt().cwiseInverse().asDiagonal();
  equations_.H.selfadjointView<Eigen::Lower>().rankUpdate(scaled, -1);
  equations_.H = Eigen::MatrixXd(equations_.H.selfadjointView<Eigen::Lower>());
  equations_.b -= depths_.coupling * depths_.b.cwiseQuotient(depths_.H);
}

Eigen::MatrixXd HostSystem::brightness_gain() const {
  return -equations_.H.bottomRightCorner(brightness(), brightness())
              .ldlt()
              .solve(equations_.H.bottomLeftCorner(brightness(), poses()));
}

NormalEquations<Eigen::Dynamic> HostSystem::increments() const {
  const Eigen::MatrixXd gain = brightness_gain();
  return {equations_.H.topLeftCorner(poses(), poses()) +
              equations_.H.topRightCorner(poses(), brightness()) * gain,
          equations_.b.head(poses()) + gain.transpose() * equations_.b.tail(brightness())};
}

HostSystem::Step HostSystem::step_with(const Eigen::VectorXd& increments) const {
  const Eigen::VectorXd by_light = equations_.b.tail(brightness());
  Eigen::VectorXd all(equations_.b.size());
  all << increments,
      brightness_gain() * increments -
          equations_.H.bottomRightCorner(brightness(), brightness()).ldlt().solve(by_light);
  return {all.tail(brightness()), depths_.step_with(all)};
}

}  // namespace vo
