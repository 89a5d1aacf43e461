#pragma once

#include <span>

namespace tools {

/// Returns the two-sided p-value of the exact permutation test of pairs (Fisher 1935): the share of
/// all choices of signs of the differences whose mean is at least as far from zero. Under the
/// hypothesis that nothing changed each sign is as likely as the other, whatever the distribution.
/// With n differences other than zero the value is at least 2^(1 - n). Values are rounded to
/// multiples of `step`, or of a finer one than a thousandth of the greatest difference.
double sign_flip_p_value(std::span<const double> before, std::span<const double> after,
                         double step);

/// Returns the two-sided p-value of the exact permutation test of two independent samples (Pitman
/// 1937): the share of all ways to divide the values into samples of these sizes whose means are at
/// least as far apart. Values are rounded to multiples of `step`, or of a thousandth of their range
/// if that is more.
double permutation_p_value(std::span<const double> before, std::span<const double> after,
                           double step);

}  // namespace tools
