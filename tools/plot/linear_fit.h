#pragma once

#include <optional>
#include <span>

namespace tools {

/// The line y = intercept + slope x.
struct LinearFit {
  double slope = 0;
  double intercept = 0;
  double r_squared = 0;  ///< coefficient of determination R^2
};

/// Returns the least-squares line; `x` and `y` have equal size. It is empty unless there are two
/// different x.
std::optional<LinearFit> fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace tools
