#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/laboratory/results.h"
#include "vo/files/output.h"

namespace tools {

/// Returns a sentence on each reason why results cannot be compared fully with a baseline: another
/// tracker, scenarios that the baseline does not have.
std::vector<std::string> baseline_notes(const TestResults& baseline, const TestResults& results);

/// Puts the results into the baseline in `file`, in place of the same scenarios' in it. A scenario
/// that could not be measured is no baseline: the earlier one, if any, stays, and a sentence on it
/// is returned. Throws vo::Error if the file holds anything else or cannot be written.
std::vector<std::string> save_baseline(const std::filesystem::path& file,
                                       const TestResults& results, const vo::OutputPolicy& policy);

}  // namespace tools
