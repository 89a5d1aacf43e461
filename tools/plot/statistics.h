#pragma once

#include <span>
#include <vector>

namespace tools {

/// Mean and standard deviation of the finite values of a sample; NaN without any.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< sample standard deviation (n - 1); 0 for a single value
};

Spread spread(std::span<const double> values);

double median(std::vector<double> values);  ///< mean of the middle two if even; NaN if empty

}  // namespace tools
