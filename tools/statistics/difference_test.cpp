#include "tools/statistics/difference_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "tools/statistics/permutation_test.h"
#include "tools/statistics/significance.h"

namespace tools {
namespace {

bool all_positive(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return v > 0; });
}

bool has_equal_values(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Returns the number of ways to choose k of n.
double binomial(std::size_t n, std::size_t k) {
  double ways = 1;
  for (std::size_t i = 1; i <= k; ++i) {
    ways *= static_cast<double>(n - k + i) / static_cast<double>(i);
  }
  return ways;
}

DifferenceTest exact_test(const Samples& samples, double step) {
  const std::size_t before = samples.before.size();
  const std::size_t after = samples.after.size();
  if (samples.paired) {
    return {sign_flip_p_value(samples.before, samples.after, step),
            std::min(1.0, std::exp2(1 - static_cast<double>(before)))};
  }
  const double sides = before == after ? 2 : 1;  // of equal sizes, both extremes are equally far
  return {permutation_p_value(samples.before, samples.after, step),
          std::min(1.0, sides / binomial(before + after, before))};
}

double t_test(Samples samples, double negligible) {
  if (all_positive(samples.before) && all_positive(samples.after)) {
    negligible /= (mean_of(samples.before) + mean_of(samples.after)) / 2;
    const auto logarithm = [](double v) { return std::log(v); };
    for (std::vector<double>* values : {&samples.before, &samples.after}) {
      std::transform(values->begin(), values->end(), values->begin(), logarithm);
    }
  }
  return samples.paired ? paired_p_value(samples.before, samples.after, negligible)
                        : welch_p_value(samples.before, samples.after, negligible);
}

}  // namespace

DifferenceTest test_difference(const Samples& samples, const Resolution& resolution) {
  const std::size_t fewest = std::min(samples.before.size(), samples.after.size());
  if (fewest == 1 && samples.paired) {
    return {samples.before[0] == samples.after[0] ? 1.0 : 0.0, 0};
  }
  if (fewest < 2) {
    return {1, 1};
  }
  const bool is_discrete =
      resolution.step > 0 || has_equal_values(samples.before) || has_equal_values(samples.after);
  return is_discrete ? exact_test(samples, resolution.step)
                     : DifferenceTest{t_test(samples, resolution.negligible), 0};
}

}  // namespace tools
