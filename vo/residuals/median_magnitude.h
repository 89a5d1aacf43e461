#pragma once

#include <span>

namespace vo {

/// Returns the median of magnitudes, of an even number the greater of the two middle ones; 0
/// without any. Magnitudes are at least 0.
float median_magnitude(std::span<const float> magnitudes);

/// Returns a robust estimate of the standard deviation of Gaussian values with these magnitudes and
/// some outliers: 1.4826 times the median.
inline double robust_sigma_of(std::span<const float> magnitudes) {
  constexpr double kMadToSigma = 1.4826;
  return kMadToSigma * static_cast<double>(median_magnitude(magnitudes));
}

}  // namespace vo
