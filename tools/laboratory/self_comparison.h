#pragma once

#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results.h"

namespace tools {

/// Returns how many of `comparisons` comparisons without a true difference raise an alarm: each
/// splits every scenario's trials at random into two halves and compares these as independent
/// samples. Throws vo::Error where a scenario has fewer than four trials.
int count_false_alarms(const TestResults& results, int comparisons,
                       const ComparisonOptions& options);

}  // namespace tools
