#include "vo/tracking/vignette_estimate.h"

#include <algorithm>

#include <Eigen/Cholesky>

#include "vo/core/normal_equations.h"

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

/// Returns the normal equations of the coefficients, in squares of the loss's scale.
NormalEquations<kCoefficients> vignette_equations(const VignettePair& pair) {
  const VignetteTerms terms(pair.view.image.camera);
  NormalEquations<kCoefficients + kParameters> all;
  decltype(all)::Vector J;
  for (std::size_t i = 0; i < pair.view.points.size(); ++i) {
    const double weight = pair.scores.weight[i];
    if (weight > 0) {
      const VignetteResidual residual = vignette_residual(pair, terms, i);
      J.head<kCoefficients>() = residual.J;
      for (int p = 0; p < kParameters; ++p) {
        J[kCoefficients + p] = pair.scores.J[static_cast<std::size_t>(p)][i];
      }
      all.add_residual(J, residual.value, weight);
    }
  }
  all.H.diagonal().tail<kParameters>() *= 1 + kDamping;
  NormalEquations<kCoefficients> result;
  result.add(all.eliminated<kParameters>(), 1 / (pair.model.scale * pair.model.scale));
  return result;
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
  const NormalEquations<kCoefficients> equations =
      vignette_equations({view, scores_, model, farthest.vignette, present});
  information_ += equations.H;
  weighted_ += equations.H * present.coefficients - equations.b;
  const Eigen::Vector2d best = information_.ldlt().solve(weighted_);
  const double chi2 = best.dot(information_ * best) / kDependence;
  vignette_.coefficients = std::max(0.0, 1 - kInsignificant / chi2) * best;
}

}  // namespace vo
