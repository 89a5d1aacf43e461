#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/laboratory/comparison.h"

namespace tools {

/// Returns the changes between two results as a document of the schema `comparison`, with the
/// scenarios that only one of them has.
nlohmann::ordered_json comparison_json(const TestResults& before, const TestResults& after,
                                       const std::vector<Change>& changes,
                                       const ComparisonOptions& options);

/// Returns how many comparisons of a result with itself raised an alarm, as a document of the
/// schema `self_comparison`.
nlohmann::ordered_json self_comparison_json(int alarms, int comparisons,
                                            const ComparisonOptions& options);

}  // namespace tools
