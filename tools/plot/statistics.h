#pragma once

#include <span>
#include <vector>

namespace tools {

/// Of finite values; NaN without any.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< standard deviation of the sample, n - 1; 0 of a single value
};

Spread spread(std::span<const double> values);

double median(std::vector<double> values);  ///< of an even number, the mean of the middle two

}  // namespace tools
