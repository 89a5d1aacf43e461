#pragma once

#include <span>
#include <vector>

namespace tools {

/// Returns P(|T| >= |t|) of Student's t-distribution with `freedom` > 0 degrees of freedom: the
/// two-sided p-value of t.
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

/// Returns the two-sided p-value of the paired t-test (Student 1908) of two pairs or more. A
/// standard deviation of the differences below `least_deviation` is taken for that, because a few
/// values may agree by chance.
double paired_p_value(std::span<const double> before, std::span<const double> after,
                      double least_deviation = 0);

/// Returns the two-sided p-value of the t-test for two independent samples of unequal variance
/// (Welch 1947); each has two values or more. A standard deviation of a sample below
/// `least_deviation` is taken for that.
double welch_p_value(std::span<const double> before, std::span<const double> after,
                     double least_deviation = 0);

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
