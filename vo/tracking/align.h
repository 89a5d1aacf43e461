#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "vo/core/se3.h"
#include "vo/image/edge_points.h"
#include "vo/tracking/robust.h"

namespace vo {

struct AlignOptions {
  int max_iterations = 30;         ///< per pyramid level
  double min_translation = 1e-5;   ///< m; a step below it and below min_rotation_deg is not taken
  double min_rotation_deg = 5e-4;  ///< deg
  RobustLoss loss = RobustLoss::huber;
  double loss_scale = 5.0 / 255;  ///< intensity; five grey levels, the paper's
  int min_points = 100;           ///< fewer visible edge points are not a fit

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, AlignOptions& options) {
  visit("max_iterations", options.max_iterations, "per pyramid level");
  visit("min_translation", options.min_translation, "a smaller step is not taken: converged, m");
  visit("min_rotation_deg", options.min_rotation_deg,
        "a smaller step is not taken: converged, deg");
  visit("loss", options.loss, "robust loss of a residual");
  visit("loss_scale", options.loss_scale, "where the loss turns linear, intensity 0..1");
  visit("min_points", options.min_points, "fewer visible points are not a fit");
}

/// Why the alignment ended on the finest level it reached.
enum class Termination {
  converged,       ///< the next step is below its limits
  no_better_step,  ///< the last step raised the cost and was undone
  max_iterations,  ///< still improving
  too_few_points,  ///< too few edge points with depth, or too few in view
  singular,        ///< the points do not determine six degrees of freedom
};

constexpr auto enum_names(Termination) {
  return std::array{std::pair{Termination::converged, "converged"},
                    std::pair{Termination::no_better_step, "no_better_step"},
                    std::pair{Termination::max_iterations, "max_iterations"},
                    std::pair{Termination::too_few_points, "too_few_points"},
                    std::pair{Termination::singular, "singular"}};
}

struct AlignResult {
  SE3 T_cur_ref;
  Termination termination = Termination::too_few_points;
  int iterations = 0;           ///< all levels together
  std::size_t points = 0;       ///< edge points of the finest level seen in the current frame
  double visible_fraction = 0;  ///< of the finest level's edge points
  double correlation = 0;       ///< of reference and current intensities at the visible points
  double cost = 0;              ///< robust, per point of the finest level, intensity^2
  Matrix6d covariance = Matrix6d::Zero();  ///< of the left increment delta of exp(delta) T_cur_ref

  bool usable() const {
    return termination != Termination::too_few_points && termination != Termination::singular;
  }
};

/// Photometric normal equations H delta = -b of exp(delta) T_cur_ref, and what they sum over.
struct LinearSystem {
  Matrix6d H = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  double cost = 0;               ///< robust, per point; unseen points count as loss scale squared
  double squared_residuals = 0;  ///< weighted sum
  std::size_t points = 0;        ///< seen
};

/// One pass over the points: r = I_cur(pi(T_cur_ref p_ref)) - I_ref (paper, Eq. 6), with the
/// forward-compositional Jacobian of Eq. 12. Double sums in the order of the points.
LinearSystem linearize(const EdgePointLevel& reference, const PyramidLevel& current,
                       const SE3& T_cur_ref, const AlignOptions& options);

/// The residual of each point, or nothing where the point is not seen. For pictures and tests.
std::vector<std::optional<float>> residuals(const EdgePointLevel& reference,
                                            const PyramidLevel& current, const SE3& T_cur_ref);

/// Pearson's correlation of the intensities of reference and current image at the points that are
/// seen, in [-1, 1]; 0 without contrast. Whatever the contrast, it is near 1 where the images were
/// brought to agree and near 0 where they show different things.
double correlation(const EdgePointLevel& reference, const PyramidLevel& current,
                   const SE3& T_cur_ref);

/// Gauss-Newton on SE(3), coarse to fine over all pyramid levels, steps that raise the cost undone.
/// Pure: same input, same output.
AlignResult align(const EdgePoints& reference, const FramePyramid& current,
                  const SE3& T_cur_ref_guess, const AlignOptions& options);

}  // namespace vo
