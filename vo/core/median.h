#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace vo {

/// The middle value; of an even number, the greater of the two in the middle; 0 without values.
template <typename Value>
Value upper_median(std::vector<Value> values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Standard deviation of Gaussian values of these magnitudes, whatever outliers are among them:
/// 1.4826 times their median.
template <typename Value>
double robust_sigma(std::vector<Value> magnitudes) {
  constexpr double kMadToSigma = 1.4826;
  return kMadToSigma * static_cast<double>(upper_median(std::move(magnitudes)));
}

}  // namespace vo
