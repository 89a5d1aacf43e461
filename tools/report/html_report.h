#pragma once

#include <string>
#include <vector>

#include "tools/report/report_bundle.h"
#include "tools/report/scenario_report.h"

namespace tools {

/// Returns one HTML file that needs no other file and no network: verdicts, and for each scenario
/// the trajectory in its scene, errors over time, pictures and options. Equal reports give equal
/// bytes. Where the bundle is missing it holds verdicts and trajectories alone and says why.
std::string html_report(const std::vector<ScenarioReport>& scenarios,
                        const ReportBundle& bundle = report_bundle());

}  // namespace tools
