#pragma once

#include <cmath>

#include <Eigen/Core>

namespace vo {

/// Returns whether a quaternion's length is 1 within what files round it to: normalised bytes, the
/// coarsest components that glTF allows, or a few decimals.
template <typename Derived>
bool is_nearly_unit(const Eigen::MatrixBase<Derived>& quaternion) {
  constexpr double kTolerance = 0.01;
  return std::abs(static_cast<double>(quaternion.stableNorm()) - 1) <= kTolerance;
}

}  // namespace vo
