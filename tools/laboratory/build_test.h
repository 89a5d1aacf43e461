#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/laboratory/results.h"
#include "vo/core/progress.h"

namespace tools {

/// Returns what another build of edvo measures: its own `edvo test` of the scenarios, each with so
/// many seeds. Throws vo::Error if it leaves no results.
TestResults test_build(const std::filesystem::path& build,
                       const std::vector<std::string>& scenarios, int seeds,
                       const vo::WaitObserver& waiting);

}  // namespace tools
