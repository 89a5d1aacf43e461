#pragma once

#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results.h"

namespace tools {

/// How many of so many comparisons raise an alarm where there is nothing to find: each splits every
/// scenario's trials at random into two halves and compares these as two results of other seeds.
/// Throws vo::Error where a scenario has fewer than four trials.
int count_false_alarms(const TestResults& results, int comparisons,
                       const ComparisonOptions& options);

}  // namespace tools
