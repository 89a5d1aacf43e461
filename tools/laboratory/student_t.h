#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tools {

/// P(T <= t) of Student's distribution; `freedom` is above 0.
double student_cdf(double t, double freedom);

/// P(|T| >= |t|).
double student_two_sided(double t, double freedom);

/// The t with P(T <= t) = probability, which lies between 0 and 1.
double student_quantile(double probability, double freedom);

/// Mean of a sample with its confidence interval, which a single value does not have: then it is
/// the value itself. NaN without values or where one is NaN.
struct Estimate {
  double mean = 0;
  double low = 0;
  double high = 0;
};

Estimate estimate_mean(std::span<const double> values, double confidence = 0.95);

/// Two-sided p-value of the hypothesis that paired values differ by nothing but chance (Student
/// 1908). Where no chance is seen - a single pair, or differences that are all the same - it is 0
/// if there is a difference and 1 if there is none.
double paired_p_value(std::span<const double> before, std::span<const double> after);

/// The same of two independent samples of unequal variance (Welch 1947); each has two values or
/// more.
double welch_p_value(std::span<const double> before, std::span<const double> after);

/// How many of a sample have a property.
struct Share {
  int having = 0;
  int of = 0;
};

/// Two-sided p-value of the hypothesis that the property is as frequent in both (Fisher's exact
/// test).
double fisher_p_value(const Share& before, const Share& after);

/// Which hypotheses are rejected so that a true one is among them with at most the probability
/// `level` (Holm 1979), as many as there are p-values.
std::vector<bool> holm_rejections(std::span<const double> p_values, double level);

}  // namespace tools
