#include "tools/laboratory/student_t.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "tools/plot/statistics.h"

namespace tools {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double log_gamma(double x) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): it writes the global signgam, which nothing reads
  return std::lgamma(x);
}

/// Returns the d-th coefficient of the continued fraction of the incomplete beta function
/// (Abramowitz and Stegun, 26.5.8).
double beta_coefficient(int d, double a, double b, double x) {
  const int half = d / 2;
  const auto m = static_cast<double>(half);
  if (d % 2 == 0) {
    return m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
  }
  return -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
}

/// Returns the continued fraction 1 / (1 + d1 / (1 + d2 / ...)), evaluated by Lentz' method.
double beta_fraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  constexpr int kMaxTerms = 1000;
  const auto away_from_zero = [](double v) { return std::abs(v) < kTiny ? kTiny : v; };
  double fraction = 1;
  double c = 1;
  double d = 0;
  for (int i = 1; i <= kMaxTerms; ++i) {
    const double term = beta_coefficient(i, a, b, x);
    d = 1 / away_from_zero(1 + term * d);
    c = away_from_zero(1 + term / c);
    fraction *= c * d;
    if (std::abs(c * d - 1) < std::numeric_limits<double>::epsilon()) {
      break;
    }
  }
  return 1 / fraction;
}

/// Returns the regularized incomplete beta function I_x(a, b).
double incomplete_beta(double a, double b, double x) {
  if (x <= 0 || x >= 1) {
    return x <= 0 ? 0 : 1;
  }
  const double front = std::exp(log_gamma(a + b) - log_gamma(a) - log_gamma(b) + a * std::log(x) +
                                b * std::log1p(-x));
  return x < (a + 1) / (a + b + 2) ? front * beta_fraction(a, b, x) / a
                                   : 1 - front * beta_fraction(b, a, 1 - x) / b;
}

double squared_error_of_mean(std::span<const double> values) {
  const double deviation = spread(values).deviation;
  return deviation * deviation / static_cast<double>(values.size());
}

double log_binomial(int n, int k) {
  return log_gamma(n + 1.0) - log_gamma(k + 1.0) - log_gamma(n - k + 1.0);
}

/// Returns whether a deviation is within floating-point rounding of the mean.
bool is_rounding(double deviation, double mean) {
  return deviation <= 1e-12 * std::abs(mean);
}

}  // namespace

double student_two_sided(double t, double freedom) {
  return incomplete_beta(freedom / 2, 0.5, freedom / (freedom + t * t));
}

double student_cdf(double t, double freedom) {
  const double tail = student_two_sided(t, freedom) / 2;
  return t < 0 ? tail : 1 - tail;
}

double student_quantile(double probability, double freedom) {
  double low = -1;
  double high = 1;
  while (student_cdf(low, freedom) > probability) {
    low *= 2;
  }
  while (student_cdf(high, freedom) < probability) {
    high *= 2;
  }
  constexpr int kBisections = 200;
  for (int i = 0; i < kBisections && low < high; ++i) {
    const double middle = (low + high) / 2;
    (student_cdf(middle, freedom) < probability ? low : high) = middle;
  }
  return (low + high) / 2;
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

double paired_p_value(std::span<const double> before, std::span<const double> after) {
  std::vector<double> differences(before.size());
  std::transform(after.begin(), after.end(), before.begin(), differences.begin(), std::minus<>());
  const Spread difference = spread(differences);
  if (differences.size() < 2 || is_rounding(difference.deviation, difference.mean)) {
    return difference.mean == 0 ? 1 : 0;
  }
  const double t = difference.mean / std::sqrt(squared_error_of_mean(differences));
  return student_two_sided(t, static_cast<double>(differences.size()) - 1);
}

double welch_p_value(std::span<const double> before, std::span<const double> after) {
  const double difference = spread(after).mean - spread(before).mean;
  const double a = squared_error_of_mean(before);
  const double b = squared_error_of_mean(after);
  if (is_rounding(std::sqrt(a + b), difference)) {
    return difference == 0 ? 1 : 0;
  }
  const double freedom = (a + b) * (a + b) /
                         (a * a / (static_cast<double>(before.size()) - 1) +
                          b * b / (static_cast<double>(after.size()) - 1));
  return student_two_sided(difference / std::sqrt(a + b), freedom);
}

double fisher_p_value(const Share& before, const Share& after) {
  const int having = before.having + after.having;
  const auto log_ways = [&](int of_before) {
    return log_binomial(before.of, of_before) + log_binomial(after.of, having - of_before);
  };
  const double log_all = log_binomial(before.of + after.of, having);
  constexpr double kRounding = 1e-9;
  const double seen = log_ways(before.having) + kRounding;
  double p_value = 0;
  for (int k = std::max(0, having - after.of); k <= std::min(having, before.of); ++k) {
    p_value += log_ways(k) <= seen ? std::exp(log_ways(k) - log_all) : 0;
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
