#include "vo/alignment/secant_hessian.h"

#include <algorithm>

namespace vo {
namespace {

/// Least share of the curvature by the normal equations that is left along a step. It limits steps
/// to some three times those of Gauss-Newton.
constexpr double kLeastShare = 0.3;

}  // namespace

void SecantHessian::add(const Vector6d& step, const Vector6d& change_of_b) {
  if (secants_.size() == kRemembered) {
    std::rotate(secants_.begin(), secants_.begin() + 1, secants_.end());
    secants_.pop_back();
  }
  secants_.push_back({step, change_of_b});
}

Matrix6d SecantHessian::corrected(const Matrix6d& H) const {
  Matrix6d result = H;
  for (const Secant& secant : secants_) {
    const Vector6d by_result = result * secant.step;
    const double curvature = secant.step.dot(by_result);
    const double shown = secant.step.dot(secant.change_of_b);
    if (shown > kLeastShare * curvature) {
      result += secant.change_of_b * secant.change_of_b.transpose() / shown -
                by_result * by_result.transpose() / curvature;
    } else if (curvature > 0) {
      result += (kLeastShare - 1) / curvature * by_result * by_result.transpose();
    }
  }
  return result;
}

}  // namespace vo
