#pragma once

#include <vector>

namespace tools {

/// Values of one quantity before and after a change; paired ones have equal indices.
struct Samples {
  std::vector<double> before;
  std::vector<double> after;
  bool paired = true;
};

/// How finely a quantity is known.
struct Resolution {
  double step = 0;        ///< values are multiples of it; 0 where they are continuous
  double negligible = 0;  ///< a standard deviation below it is taken for this
};

struct DifferenceTest {
  double p_value = 1;
  double least_p_value = 0;  ///< the smallest p-value that samples of these sizes can have
};

/// Tests the hypothesis that nothing changed, two-sided. Finite samples only.
/// - A continuous quantity whose values all differ is tested by Student's paired or Welch's t-test.
///   Errors vary by factors, so positive values are compared by their logarithms, which are nearer
///   to normal.
/// - A discrete one, or one with equal values in a sample, is tested by the exact permutation test:
///   equal values say nothing of how far the next one may be off.
/// - A single pair is taken for one run of a deterministic program: every difference is its
///   change, p = 0.
DifferenceTest test_difference(const Samples& samples, const Resolution& resolution);

}  // namespace tools
