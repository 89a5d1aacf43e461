#pragma once

#include <cstddef>

#include "vo/core/inplace_vector.h"
#include "vo/geometry/se3.h"

namespace vo {

/// The Hessian of a robust loss, as far as steps have shown it.
///
/// The normal equations of a robust loss hold its weights fixed, which overstates the curvature:
/// far residuals weigh the less the farther a step takes them. Gauss-Newton steps are therefore too
/// short and the pose is approached by a constant factor only. The change of b along a step shows
/// the curvature in its direction; BFGS updates put it in the place of that of H (Nocedal & Wright,
/// Numerical Optimization, 2006, Eq. 6.19).
class SecantHessian {
 public:
  /// Takes in a step and the change of b along it. Of many steps the last are remembered.
  void add(const Vector6d& step, const Vector6d& change_of_b);

  /// Returns the normal equations' H with the curvature that the steps showed, oldest first. A
  /// share of the curvature by H is left in any case, so that the result is as positive as H.
  Matrix6d corrected(const Matrix6d& H) const;

 private:
  struct Secant {
    Vector6d step;
    Vector6d change_of_b;
  };

  static constexpr std::size_t kRemembered = 6;

  InplaceVector<Secant, kRemembered> secants_;
};

}  // namespace vo
