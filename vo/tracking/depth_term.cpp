#include "vo/tracking/depth_term.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "vo/core/median.h"
#include "vo/tracking/robust.h"

namespace vo {
namespace {

/// A surface point where the pose puts it.
struct Placed {
  Eigen::Vector3d position;  // m, current frame
  Eigen::Vector3d normal;
  double distance;  // m, of the measured point from the plane
  Eigen::Vector2d pixel;
};

/// Puts surface points where the view's pose has them.
class Placement {
 public:
  explicit Placement(const DepthView& view)
      : view_(view),
        R_cur_ref_(view.T_cur_ref.rotation_matrix()),
        t_cur_ref_(view.T_cur_ref.translation()) {}

  /// Nothing where no depth is measured, or one of another surface.
  std::optional<Placed> of(std::size_t i) const {
    constexpr double kMaxStep = 0.1;  // of the depth
    const Eigen::Vector3d p = R_cur_ref_ * view_.surface.position[i].cast<double>() + t_cur_ref_;
    if (!(p.z() > 0)) {
      return {};
    }
    const Eigen::Vector2d pixel = view_.image.camera.project(p);
    if (!view_.image.camera.contains(pixel)) {
      return {};
    }
    const auto u = static_cast<int>(std::floor(pixel.x() + 0.5));
    const auto v = static_cast<int>(std::floor(pixel.y() + 0.5));
    const auto depth = static_cast<double>(view_.image.depth(v, u));
    if (!(depth > 0) || std::abs(depth - p.z()) > kMaxStep * p.z()) {
      return {};
    }
    const cv::Vec2f ray = view_.image.rays(v, u);
    const Eigen::Vector3d measured = depth * Eigen::Vector3d(ray[0], ray[1], 1);
    const Eigen::Vector3d normal = R_cur_ref_ * view_.surface.normal[i].cast<double>();
    return Placed{p, normal, normal.dot(p - measured), pixel};
  }

 private:
  const DepthView& view_;
  Eigen::Matrix3d R_cur_ref_;
  Eigen::Vector3d t_cur_ref_;
};

struct Term {
  Vector6d J;
  RobustValue robust;
};

Term term_of(const Placed& point, float scale) {
  Term term;
  term.J << point.normal, point.position.cross(point.normal);
  term.robust = robust_value<RobustLoss::student_t>(static_cast<float>(point.distance), scale);
  return term;
}

}  // namespace

DepthSystem linearize_depth(const DepthView& view, double scale) {
  DepthSystem system;
  const Placement placement(view);
  const auto scale_m = static_cast<float>(scale);
  const auto unseen =
      static_cast<double>(robust_value<RobustLoss::student_t>(scale_m, scale_m).loss);
  for (std::size_t i = 0; i < view.surface.size(); ++i) {
    const std::optional<Placed> point = placement.of(i);
    if (!point) {
      system.cost += unseen;
      continue;
    }
    const Term term = term_of(*point, scale_m);
    const auto weight = static_cast<double>(term.robust.weight);
    system.H += weight * term.J * term.J.transpose();
    system.b += weight * point->distance * term.J;
    system.cost += static_cast<double>(term.robust.loss);
  }
  return system;
}

std::vector<DepthScore> score_depth(const DepthView& view, double scale) {
  std::vector<DepthScore> scores;
  const Placement placement(view);
  for (std::size_t i = 0; i < view.surface.size(); ++i) {
    if (const std::optional<Placed> point = placement.of(i)) {
      const Term term = term_of(*point, static_cast<float>(scale));
      const double weight = static_cast<double>(term.robust.weight) * point->distance;
      scores.push_back({point->pixel, weight * term.J});
    }
  }
  return scores;
}

double distance_spread(const DepthView& view) {
  std::vector<double> magnitudes;
  const Placement placement(view);
  for (std::size_t i = 0; i < view.surface.size(); ++i) {
    if (const std::optional<Placed> point = placement.of(i)) {
      magnitudes.push_back(std::abs(point->distance));
    }
  }
  return robust_sigma(std::move(magnitudes));
}

}  // namespace vo
