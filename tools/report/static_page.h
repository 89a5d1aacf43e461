#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/report/scenario_report.h"

namespace tools {

/// Returns the body of a report without scripts: the note, verdicts, metrics and trajectories.
std::string static_page(const std::vector<ScenarioReport>& scenarios, std::string_view note);

}  // namespace tools
