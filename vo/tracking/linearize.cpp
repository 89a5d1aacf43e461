#include "vo/tracking/align.h"
#include "vo/tracking/warp.h"

namespace vo {
namespace {

constexpr float kMinDepth = 0.05F;  // m; nearer points are behind the lens or about to be

/// The points of a level as the current image sees them under one pose.
class Viewer {
 public:
  Viewer(const EdgePointLevel& reference, const PyramidLevel& current, const SE3& T_cur_ref)
      : reference_(reference),
        current_(current),
        warp_(current.camera, T_cur_ref),
        max_u_(static_cast<float>(current.camera.width - 1)),
        max_v_(static_cast<float>(current.camera.height - 1)) {}

  /// False where point i is not seen.
  bool warp(std::size_t i, WarpedPoint<float>& point) const {
    point =
        warp_point<float>(warp_, {reference_.x_ref[i], reference_.y_ref[i], reference_.z_ref[i]});
    return point.p_cur.z() > kMinDepth && point.u >= 0 && point.u < max_u_ && point.v >= 0 &&
           point.v < max_v_;
  }

  float residual(std::size_t i, const BilinearWeights& at) const {
    return at(current_.intensity) - reference_.intensity[i];
  }

  cv::Vec2f gradient(const BilinearWeights& at) const { return at(current_.gradient); }

 private:
  const EdgePointLevel& reference_;
  const PyramidLevel& current_;
  Warp<float> warp_;
  float max_u_;
  float max_v_;
};

}  // namespace

LinearSystem linearize(const EdgePointLevel& reference, const PyramidLevel& current,
                       const SE3& T_cur_ref, const AlignOptions& options) {
  const Viewer viewer(reference, current, T_cur_ref);
  const auto scale = static_cast<float>(options.loss_scale);
  LinearSystem system;
  double loss = 0;
  WarpedPoint<float> point;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (!viewer.warp(i, point)) {
      continue;
    }
    const BilinearWeights at(point.u, point.v);
    const float r = viewer.residual(i, at);
    const cv::Vec2f gradient = viewer.gradient(at);
    const RobustValue robust = robust_value(options.loss, r, scale);
    const Vector6d J = forward_jacobian(point, gradient[0], gradient[1]).cast<double>();
    const Vector6d J_weighted = robust.weight * J;

    system.H.noalias() += J_weighted * J.transpose();
    system.b.noalias() += J_weighted * static_cast<double>(r);
    system.squared_residuals += static_cast<double>(robust.weight * r * r);
    loss += static_cast<double>(robust.loss);
    ++system.points;
  }
  const auto total = static_cast<double>(reference.size());
  const auto unseen = static_cast<double>(reference.size() - system.points);
  system.cost = total > 0 ? (loss + unseen * options.loss_scale * options.loss_scale) / total : 0;
  return system;
}

std::vector<std::optional<float>> residuals(const EdgePointLevel& reference,
                                            const PyramidLevel& current, const SE3& T_cur_ref) {
  const Viewer viewer(reference, current, T_cur_ref);
  std::vector<std::optional<float>> result(reference.size());
  WarpedPoint<float> point;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (viewer.warp(i, point)) {
      result[i] = viewer.residual(i, BilinearWeights(point.u, point.v));
    }
  }
  return result;
}

double correlation(const EdgePointLevel& reference, const PyramidLevel& current,
                   const SE3& T_cur_ref) {
  const std::vector<std::optional<float>> residual = residuals(reference, current, T_cur_ref);
  double n = 0;
  double sum_ref = 0;
  double sum_cur = 0;
  double sum_ref_ref = 0;
  double sum_cur_cur = 0;
  double sum_ref_cur = 0;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    if (!residual[i]) {
      continue;
    }
    const double ref = reference.intensity[i];
    const double cur = ref + *residual[i];
    n += 1;
    sum_ref += ref;
    sum_cur += cur;
    sum_ref_ref += ref * ref;
    sum_cur_cur += cur * cur;
    sum_ref_cur += ref * cur;
  }
  const double variances =
      (n * sum_ref_ref - sum_ref * sum_ref) * (n * sum_cur_cur - sum_cur * sum_cur);
  return variances > 0 ? (n * sum_ref_cur - sum_ref * sum_cur) / std::sqrt(variances) : 0;
}

}  // namespace vo
