#pragma once

#include <string>
#include <vector>

#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results.h"

namespace tools {

/// What `edvo test` prints: a line per scenario, then every complaint, alarm and note as a
/// sentence, then how many scenarios passed.
std::string format_verdicts(const TestResults& results, const std::vector<Change>& changes);

/// What `edvo compare` prints: the changes worth a look, alarms first, and a sentence on the rest.
std::string format_changes(const std::vector<Change>& changes);

}  // namespace tools
