#include "tools/statistics/power.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "vo/core/random.h"

namespace tools {
namespace {

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Draws a comparison of a quantity that did not change.
Samples draw_samples(const ComparisonDesign& design, vo::Random& random) {
  Samples samples{.before = {}, .after = {}, .paired = design.paired};
  for (int i = 0; i < design.seeds; ++i) {
    const double before = std::exp(design.deviation * random.normal());
    samples.before.push_back(before);
    samples.after.push_back(design.paired
                                ? before * std::exp(design.pair_deviation * random.normal())
                                : std::exp(design.deviation * random.normal()));
  }
  return samples;
}

bool is_found(Samples samples, double factor, const ComparisonDesign& design) {
  for (double& value : samples.after) {
    value *= factor;
  }
  return sum_of(samples.after) > design.least_factor * sum_of(samples.before) &&
         test_difference(samples, {}).p_value <= design.level;
}

constexpr double kGreatestFactor = 100;

/// Returns the smallest factor with which the drawn comparison is an alarm.
double least_found_factor(const Samples& samples, const ComparisonDesign& design) {
  constexpr int kBisections = 20;
  double low = 0;
  double high = std::log(kGreatestFactor);
  if (!is_found(samples, kGreatestFactor, design)) {
    return std::numeric_limits<double>::infinity();
  }
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (low + high) / 2;
    (is_found(samples, std::exp(middle), design) ? high : low) = middle;
  }
  return std::exp(high);
}

}  // namespace

double detectable_factor(const ComparisonDesign& design, double power, int draws) {
  constexpr std::uint64_t kSeed = 1;
  vo::Random random(kSeed);
  std::vector<double> factors;
  for (int i = 0; i < draws; ++i) {
    factors.push_back(least_found_factor(draw_samples(design, random), design));
  }
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(power * draws)) - 1;
  std::nth_element(factors.begin(), factors.begin() + rank, factors.end());
  return factors[static_cast<std::size_t>(rank)];
}

}  // namespace tools
