#pragma once

#include <optional>
#include <span>

namespace tools {

/// y = intercept + slope x.
struct LinearFit {
  double slope = 0;
  double intercept = 0;
  double r_squared = 0;  ///< share of y's variance that the line explains
};

/// Least squares; as many y as x. Nothing unless there are two different x.
std::optional<LinearFit> fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace tools
