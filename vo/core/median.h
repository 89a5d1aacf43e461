#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace vo {

/// Returns the median, of an even number the greater of the two middle values; 0 without values.
/// The values are reordered.
template <typename Value>
Value reordered_median(std::span<Value> values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the median as `reordered_median` does, of values that stay as they are.
template <typename Value>
Value upper_median(std::vector<Value> values) {
  return reordered_median(std::span<Value>(values));
}

/// Returns a robust estimate of the standard deviation of Gaussian values with these magnitudes and
/// some outliers: 1.4826 times the median. The magnitudes are reordered.
template <typename Value>
double robust_sigma(std::span<Value> magnitudes) {
  constexpr double kMadToSigma = 1.4826;
  return kMadToSigma * static_cast<double>(reordered_median(magnitudes));
}

/// Returns the robust estimate of the standard deviation of magnitudes that stay as they are.
template <typename Value>
double robust_sigma(std::vector<Value> magnitudes) {
  return robust_sigma(std::span<Value>(magnitudes));
}

}  // namespace vo
