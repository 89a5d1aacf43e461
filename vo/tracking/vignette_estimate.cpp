#include "vo/tracking/vignette_estimate.h"

#include <algorithm>

#include <Eigen/Cholesky>

namespace vo {
namespace {

/// Errors of neighbouring points are alike, and the same points are seen in frame after frame:
/// together they are worth a hundredth of as many independent points.
constexpr double kDependence = 100;

/// Information of the prior: a standard deviation of 0.2 for each coefficient.
constexpr double kVignettePriorInformation = kDependence / (0.2 * 0.2);

constexpr double kDamping = 1e-6;  ///< keeps the eliminated block invertible

constexpr double kInsignificant = 4;  ///< chi^2 up to which no vignette is assumed

constexpr int kCoefficients = 2;
constexpr auto kParameters = static_cast<int>(kPassParameters);

/// The normal equations' types for the coefficients and the eliminated parameters.
using Vector10d = Eigen::Matrix<double, kCoefficients + kParameters, 1>;
using Matrix10d = Eigen::Matrix<double, kCoefficients + kParameters, kCoefficients + kParameters>;

/// A pair of images between which a vignette shows.
struct VignettePair {
  PointView view;
  const PointTerms& scores;
  ResidualModel model;
  const Vignette& of_points;  ///< removed from the points' image
  const Vignette& of_image;   ///< removed from the image they are looked up in
};

/// A point's residual and its derivatives by the coefficients, as if the image's vignette had been
/// removed from both images. The mean of both intensities stands for that of the scene, so that
/// noise biases neither side.
struct VignetteResidual {
  double value;  ///< intensity
  Eigen::Vector2d J;
};

VignetteResidual vignette_residual(const VignettePair& pair, const VignetteTerms& terms,
                                   std::size_t i) {
  const cv::Point pixel = pair.view.points.pixel[i];
  const Eigen::Vector2d at_point = terms.at(pixel.x, pixel.y);
  const Eigen::Vector2d at_image = terms.at(pair.scores.u[i], pair.scores.v[i]);
  const double point_gain = pair.of_image.gain(at_point);
  const double expected = pair.model.brightness.gain * pair.view.points.intensity[i];
  const double seen = pair.scores.residual[i] + expected + pair.model.brightness.offset;
  const double value =
      pair.scores.residual[i] - expected * (point_gain / pair.of_points.gain(at_point) - 1);
  const Eigen::Vector2d logarithmic =
      at_image / pair.of_image.gain(at_image) - at_point / point_gain;
  return {value, (seen - value / 2) * logarithmic};
}

/// The normal equations H delta = -b of the coefficients, in squares of the loss's scale.
struct VignetteSystem {
  Eigen::Matrix2d H;
  Eigen::Vector2d b;
};

VignetteSystem vignette_system(const VignettePair& pair) {
  const VignetteTerms terms(pair.view.image.camera);
  Matrix10d H = Matrix10d::Zero();
  Vector10d b = Vector10d::Zero();
  Vector10d J;
  for (std::size_t i = 0; i < pair.view.points.size(); ++i) {
    const double weight = pair.scores.weight[i];
    if (weight > 0) {
      const VignetteResidual residual = vignette_residual(pair, terms, i);
      J.head<kCoefficients>() = residual.J;
      for (int p = 0; p < kParameters; ++p) {
        J[kCoefficients + p] = pair.scores.J[static_cast<std::size_t>(p)][i];
      }
      H.noalias() += weight * J * J.transpose();
      b.noalias() += weight * residual.value * J;
    }
  }
  using Eliminated = Eigen::Matrix<double, kParameters, kParameters>;
  Eliminated H_eliminated = H.bottomRightCorner<kParameters, kParameters>();
  H_eliminated.diagonal() *= 1 + kDamping;
  const Eigen::Matrix<double, kParameters, kCoefficients> shares =
      H_eliminated.ldlt().solve(H.bottomLeftCorner<kParameters, kCoefficients>());
  const double inverse_variance = 1 / (pair.model.scale * pair.model.scale);
  return {
      inverse_variance * (H.topLeftCorner<kCoefficients, kCoefficients>() -
                          shares.transpose() * H.bottomLeftCorner<kParameters, kCoefficients>()),
      inverse_variance * (b.head<kCoefficients>() - shares.transpose() * b.tail<kParameters>())};
}

}  // namespace

VignetteEstimate::VignetteEstimate()
    : information_(kVignettePriorInformation * Eigen::Matrix2d::Identity()) {}

void VignetteEstimate::update(std::span<const AlignReference> references,
                              const AlignCurrent& current, const SE3& T_cur_first,
                              const AlignOptions& options) {
  const AlignReference& farthest = references.back();
  JointProblem problem(references.last(1), current, /*level=*/0, options);
  problem.match_brightness(T_cur_first);
  problem.estimate_scales(T_cur_first);
  const PointView view = problem.forward_view(0, T_cur_first);
  const ResidualModel& model = problem.models().front();
  const Vignette& present = current.frame.vignette;
  compute_point_terms(view, options, model, scores_);
  const VignetteSystem system = vignette_system({view, scores_, model, farthest.vignette, present});
  information_ += system.H;
  weighted_ += system.H * present.coefficients - system.b;
  const Eigen::Vector2d best = information_.ldlt().solve(weighted_);
  const double chi2 = best.dot(information_ * best) / kDependence;
  vignette_.coefficients = std::max(0.0, 1 - kInsignificant / chi2) * best;
}

}  // namespace vo
