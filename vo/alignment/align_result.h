#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "vo/geometry/se3.h"

namespace vo {

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

/// How the least loss of an alignment, all else moved along, changes with the read-out time.
struct LossByReadout {
  double slope = 0;      ///< 1/s
  double curvature = 0;  ///< 1/s^2
};

struct AlignResult {
  SE3 T_cur_ref;  ///< ref is the first reference
  Termination termination = Termination::too_few_points;
  int iterations = 0;           ///< all levels together
  std::size_t points = 0;       ///< of the finest level, seen, of all pairs of images together
  double visible_fraction = 0;  ///< of the first reference's points of the finest level
  double correlation = 0;       ///< of first reference and current intensities at visible points
  double depth_agreement = 1;   ///< share of the first reference's surfaces that are measured where
                                ///< they would be seen; 1 where none are compared
  double cost = 0;              ///< robust, per point of the finest level, in squares of its scale
  double conditioning = 0;      ///< least over greatest eigenvalue of the scaled normal equations;
                                ///< near 0 a direction of motion is not determined
  double gain = 1;    ///< the current image shows gain I_ref + offset, ref the first reference
  double offset = 0;  ///< intensity
  /// Of the left increment delta of exp(delta) T_cur_ref; see pose_covariance().
  Matrix6d covariance = Matrix6d::Zero();

  LossByReadout loss_by_readout;  ///< 0 where it is not known how fast the camera moves

  bool usable() const {
    return termination != Termination::too_few_points && termination != Termination::singular;
  }
};

}  // namespace vo
