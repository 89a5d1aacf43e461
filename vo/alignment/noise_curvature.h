#pragma once

#include "vo/geometry/se3.h"
#include "vo/residuals/point_pass.h"

namespace vo {

/// Returns normal equations whose H, with the brightness eliminated, is the part N of a pair's H
/// that is of noise: what the gradients of either image do not share with those of the other.
///
/// With J = (J_cur + J_ref) / 2, the mean of both images' Jacobians (Formulation::esm), noise of
/// the gradients adds to the sum H of w J J^T whatever there is to be seen. The noise of two images
/// is independent, so that the sum of w (J_cur J_ref^T + J_ref J_cur^T) / 2 has none in
/// expectation. H less that is the sum of w D D^T with D = (J_cur - J_ref) / 2. A direction of
/// motion along which nothing changes, such as that of parallel stripes, has no other curvature.
///
/// Gradients differ without noise, too, where the surface is inclined and the views have different
/// directions: the image of a table's edge turns as one walks past. What the surface explains, with
/// the normal that the current depth image has, is no part of D; nor is, where there is no depth,
/// what any surface inclined by up to 72 deg explains.
///
/// `terms` must have been computed from the view by Formulation::esm. The equations' b is 0.
PointEquations noise_equations(const PointView& view, const PointTerms& terms);

/// The curvature H - N of a loss, to whose H noise adds N.
class NoiseFreeCurvature {
 public:
  /// H must be positive definite.
  NoiseFreeCurvature(const Matrix6d& H, const Matrix6d& noise);

  /// Returns the greatest share of N in H among all directions of motion, at most 1. Near 1 the
  /// images have nothing in common along that direction, and the pose may be wrong by any distance.
  double noise_share() const { return shares_.maxCoeff(); }

  /// Returns the inverse of H - N, where a tenth of H is left in any direction.
  Matrix6d inverse() const;

 private:
  Vector6d shares_;      ///< eigenvalues of L^-1 N L^-T, where H = L L^T, at most 1
  Matrix6d directions_;  ///< V with V^T H V = I and V^T N V diagonal
};

}  // namespace vo
