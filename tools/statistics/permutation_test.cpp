#include "tools/statistics/permutation_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace tools {
namespace {

/// Returns each value's distance from `origin` in steps: of the wanted size or, where the farthest
/// value would have more than a thousand, a thousandth of its distance. A permutation test of such
/// rounded values is as exact as one of the values themselves.
std::vector<std::size_t> in_steps(std::span<const double> values, double origin, double step) {
  constexpr double kMostSteps = 1000;
  double farthest = 0;
  for (const double value : values) {
    farthest = std::max(farthest, std::abs(value - origin));
  }
  const double size = std::max(step, farthest / kMostSteps);
  std::vector<std::size_t> steps(values.size(), 0);
  if (size > 0) {
    std::transform(values.begin(), values.end(), steps.begin(), [&](double value) {
      return static_cast<std::size_t>(std::llround(std::abs(value - origin) / size));
    });
  }
  return steps;
}

std::size_t sum_of(std::span<const std::size_t> numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), std::size_t{0});
}

/// Returns how many subsets of the numbers have each sum, by the number of their elements up to
/// `most`: element [count][sum].
std::vector<std::vector<double>> count_subsets(std::span<const std::size_t> numbers,
                                               std::size_t most) {
  const std::size_t total = sum_of(numbers);
  std::vector<std::vector<double>> subsets(most + 1, std::vector<double>(total + 1, 0));
  subsets[0][0] = 1;
  std::size_t reached = 0;  // the greatest sum so far
  for (const std::size_t number : numbers) {
    for (std::size_t count = most; count-- > 0;) {
      for (std::size_t sum = 0; sum <= reached; ++sum) {
        subsets[count + 1][sum + number] += subsets[count][sum];
      }
    }
    reached += number;
  }
  return subsets;
}

/// Returns the share of the subsets whose sum's distance from `center` is at least `seen`; sums are
/// taken `scale` times, so that all are integers.
double share_as_far(const std::vector<double>& subsets, long scale, long center, long seen) {
  double as_far = 0;
  double all = 0;
  for (std::size_t sum = 0; sum < subsets.size(); ++sum) {
    all += subsets[sum];
    as_far += std::abs(scale * static_cast<long>(sum) - center) >= seen ? subsets[sum] : 0;
  }
  return as_far / all;
}

/// Returns how many subsets of the numbers, of any size, have each sum.
std::vector<double> count_signs(std::span<const std::size_t> numbers) {
  std::vector<double> signs(sum_of(numbers) + 1, 0);
  signs[0] = 1;
  std::size_t reached = 0;
  for (const std::size_t number : numbers) {
    reached += number;
    for (std::size_t sum = reached + 1; sum-- > 0;) {
      signs[sum] += sum >= number ? signs[sum - number] : 0;
    }
  }
  return signs;
}

}  // namespace

double sign_flip_p_value(std::span<const double> before, std::span<const double> after,
                         double step) {
  std::vector<double> differences(before.size());
  std::transform(after.begin(), after.end(), before.begin(), differences.begin(), std::minus<>());
  const std::vector<std::size_t> sizes = in_steps(differences, 0, step);
  std::size_t positive = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    positive += differences[i] > 0 ? sizes[i] : 0;
  }
  const auto total = static_cast<long>(sum_of(sizes));
  return share_as_far(count_signs(sizes), 2, total,
                      std::abs(2 * static_cast<long>(positive) - total));
}

double permutation_p_value(std::span<const double> before, std::span<const double> after,
                           double step) {
  std::vector<double> all(before.begin(), before.end());
  all.insert(all.end(), after.begin(), after.end());
  const double least = all.empty() ? 0 : *std::min_element(all.begin(), all.end());
  const std::vector<std::size_t> steps = in_steps(all, least, step);
  const auto count = static_cast<long>(all.size());
  const long center = static_cast<long>(before.size()) * static_cast<long>(sum_of(steps));
  const auto sum_before = static_cast<long>(sum_of(std::span(steps).first(before.size())));
  return share_as_far(count_subsets(steps, before.size()).back(), count, center,
                      std::abs(count * sum_before - center));
}

}  // namespace tools
