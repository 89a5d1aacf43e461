#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace vo {

/// Returns the median, of an even number the greater of the two middle values; 0 without values.
template <typename Value>
Value upper_median(std::vector<Value> values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns a robust estimate of the standard deviation of Gaussian values with these magnitudes and
/// some outliers: 1.4826 times the median.
template <typename Value>
double robust_sigma(std::vector<Value> magnitudes) {
  constexpr double kMadToSigma = 1.4826;
  return kMadToSigma * static_cast<double>(upper_median(std::move(magnitudes)));
}

}  // namespace vo
