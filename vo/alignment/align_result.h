#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "vo/core/inplace_vector.h"
#include "vo/geometry/se3.h"
#include "vo/residuals/view_agreement.h"

namespace vo {

/// Most references of an alignment.
inline constexpr std::size_t kMaxReferences = 20;

/// Most pairs of images of an alignment: each reference forward and backward.
inline constexpr std::size_t kMaxPairs = 2 * kMaxReferences;

/// The reason why the alignment ended on the finest level it reached.
enum class Termination {
  converged,       ///< the next step is below its limits
  no_better_step,  ///< the last step raised the cost and was undone
  max_iterations,  ///< the iterations ran out while the cost still fell
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

/// Derivatives of an alignment's minimal robust loss by the read-out times along rows and along
/// columns, in the order of ReadoutAxis, all else re-optimised.
struct LossByReadout {
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();      ///< 1/s
  Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();  ///< 1/s^2
};

struct AlignResult {
  SE3 T_cur_ref;  ///< ref is the first reference
  Termination termination = Termination::too_few_points;
  int iterations = 0;           ///< iterations of all levels together
  std::size_t points = 0;       ///< seen points of the finest level over all pairs of images
  double visible_fraction = 0;  ///< share of the first reference's finest points that is seen
  double correlation = 0;       ///< correlation of reference and current intensity at seen points
  double depth_agreement = 1;   ///< share of the first reference's surfaces that are measured where
                                ///< they would be seen; 1 where none are compared
  double mean_depth = 0;        ///< m, of the first reference's finest points
  double cost = 0;              ///< robust loss per point of the finest level, in squared scales
  double conditioning = 0;      ///< least over greatest eigenvalue of the scaled normal equations;
                                ///< near 0 a direction of motion is not determined
  double noise_share = 0;       ///< NoiseFreeCurvature::noise_share()
  double gain = 1;    ///< the current image shows gain I_ref + offset, ref the first reference
  double offset = 0;  ///< intensity, offset from the first reference's brightness
  /// Covariance of the left increment delta of exp(delta) T_cur_ref; see pose_covariance().
  Matrix6d covariance = Matrix6d::Zero();

  /// Models of the finest level's pairs of images, in the order of JointProblem.
  InplaceVector<ResidualModel, kMaxPairs> models;
  ViewAgreement agreement;        ///< of the first reference's points with the current image
  LossByReadout loss_by_readout;  ///< 0 where the camera's velocity is not known

  /// Returns the standard deviation of the position relative to the first reference, over the depth
  /// of its points.
  double position_deviation() const {
    return std::sqrt(covariance.topLeftCorner<3, 3>().trace()) / mean_depth;
  }

  bool usable() const {
    return termination != Termination::too_few_points && termination != Termination::singular;
  }
};

}  // namespace vo
