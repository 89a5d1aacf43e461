#pragma once

#include "tools/statistics/difference_test.h"

namespace tools {

/// How a quantity that varies by factors is compared: its logarithm is taken for normal.
struct ComparisonDesign {
  int seeds = 2;              ///< number of values before and after, 2 or more
  double deviation = 0;       ///< standard deviation of the logarithms between seeds
  double pair_deviation = 0;  ///< standard deviation of the logarithms' differences of pairs
  bool paired = true;
  double level = 0.01;        ///< p-value up to which a difference is significant
  double least_factor = 1.1;  ///< ratio of the means above which a difference is large
};

/// Returns the factor by which a quantity must grow for the change to be significant and large in a
/// `power` share of the comparisons; infinite beyond a factor of 100. Simulated with `draws`
/// comparisons whose random numbers are always the same.
double detectable_factor(const ComparisonDesign& design, double power, int draws);

}  // namespace tools
