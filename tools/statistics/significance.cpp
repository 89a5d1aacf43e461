#include "tools/statistics/significance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <boost/math/distributions/hypergeometric.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "tools/plot/statistics.h"

namespace tools {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double squared_error_of_mean(std::span<const double> values, double least_deviation = 0) {
  const double deviation = std::max(spread(values).deviation, least_deviation);
  return deviation * deviation / static_cast<double>(values.size());
}

/// Returns the two-sided p-value of a difference with a standard error, which may be zero.
double p_value_of(double difference, double error, double freedom) {
  return difference == 0 ? 1 : student_two_sided(difference / error, freedom);
}

}  // namespace

double student_two_sided(double t, double freedom) {
  const boost::math::students_t distribution(freedom);
  return 2 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)));
}

double student_quantile(double probability, double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom), probability);
}

Estimate estimate_mean(std::span<const double> values, double confidence) {
  if (values.empty() ||
      std::any_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v); })) {
    return {kUnknown, kUnknown, kUnknown};
  }
  const double mean = spread(values).mean;
  if (values.size() == 1) {
    return {mean, mean, mean};
  }
  const double freedom = static_cast<double>(values.size()) - 1;
  const double half =
      student_quantile((1 + confidence) / 2, freedom) * std::sqrt(squared_error_of_mean(values));
  return {mean, mean - half, mean + half};
}

double paired_p_value(std::span<const double> before, std::span<const double> after,
                      double least_deviation) {
  std::vector<double> differences(before.size());
  std::transform(after.begin(), after.end(), before.begin(), differences.begin(), std::minus<>());
  return p_value_of(spread(differences).mean,
                    std::sqrt(squared_error_of_mean(differences, least_deviation)),
                    static_cast<double>(differences.size()) - 1);
}

double welch_p_value(std::span<const double> before, std::span<const double> after,
                     double least_deviation) {
  const double difference = spread(after).mean - spread(before).mean;
  const double a = squared_error_of_mean(before, least_deviation);
  const double b = squared_error_of_mean(after, least_deviation);
  const double least_freedom = static_cast<double>(std::min(before.size(), after.size())) - 1;
  const double freedom = (a + b) * (a + b) /
                         (a * a / (static_cast<double>(before.size()) - 1) +
                          b * b / (static_cast<double>(after.size()) - 1));
  return p_value_of(difference, std::sqrt(a + b), a + b > 0 ? freedom : least_freedom);
}

double fisher_p_value(const Share& before, const Share& after) {
  const int having = before.having + after.having;
  const boost::math::hypergeometric distribution(having, before.of, before.of + after.of);
  constexpr double kRounding = 1e-9;
  const double seen = boost::math::pdf(distribution, before.having) * (1 + kRounding);
  double p_value = 0;
  for (int k = std::max(0, having - after.of); k <= std::min(having, before.of); ++k) {
    const double probability = boost::math::pdf(distribution, k);
    p_value += probability <= seen ? probability : 0;
  }
  return std::min(p_value, 1.0);
}

std::vector<bool> holm_rejections(std::span<const double> p_values, double level) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<bool> rejected(p_values.size(), false);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (p_values[order[i]] > level / static_cast<double>(order.size() - i)) {
      break;
    }
    rejected[order[i]] = true;
  }
  return rejected;
}

}  // namespace tools
