#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tools {

/// Returns P(T <= t) of Student's t-distribution with `freedom` > 0 degrees of freedom.
double student_cdf(double t, double freedom);

/// Returns P(|T| >= |t|) of Student's t-distribution: the two-sided p-value of t.
double student_two_sided(double t, double freedom);

/// Returns the quantile t with P(T <= t) = probability, which lies between 0 and 1.
double student_quantile(double probability, double freedom);

/// Mean of a sample with its confidence interval, which has zero width for a single value. All are
/// NaN without values or where one is NaN or infinite.
struct Estimate {
  double mean = 0;
  double low = 0;
  double high = 0;
};

Estimate estimate_mean(std::span<const double> values, double confidence = 0.95);

/// Returns the two-sided p-value of the paired t-test (Student 1908). Without variance to estimate
/// - a single pair, or differences that are all equal - it is 0 if the mean difference is not zero
/// and 1 if it is.
double paired_p_value(std::span<const double> before, std::span<const double> after);

/// Returns the two-sided p-value of the t-test for two independent samples of unequal variance
/// (Welch 1947); each has two values or more.
double welch_p_value(std::span<const double> before, std::span<const double> after);

/// Number of elements of a sample that have a property.
struct Share {
  int having = 0;
  int of = 0;
};

/// Returns the two-sided p-value of the hypothesis that a property is equally frequent in both
/// samples (Fisher's exact test).
double fisher_p_value(const Share& before, const Share& after);

/// Returns for each p-value whether its hypothesis is rejected by the Holm-Bonferroni method (1979)
/// with the family-wise error rate `level`.
std::vector<bool> holm_rejections(std::span<const double> p_values, double level);

}  // namespace tools
