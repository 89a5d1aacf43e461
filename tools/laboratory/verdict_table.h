#pragma once

#include <string>
#include <vector>

#include "tools/colour/colour.h"
#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results.h"

namespace tools {

/// Returns what `edvo test` prints: a line per scenario, then every complaint, alarm and note as a
/// sentence, then the number of scenarios by verdict.
std::string format_verdicts(const TestResults& results, const std::vector<Change>& changes,
                            const Colours& colours = {});

/// Returns what `edvo compare` prints: the changes that are large or significant, alarms first, and
/// a sentence on the others.
std::string format_changes(const std::vector<Change>& changes, const Colours& colours = {});

}  // namespace tools
