#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/report/report_bundle.h"
#include "tools/report/scenario_report.h"
#include "vo/files/output.h"

namespace tools {

/// One HTML file that needs nothing beside it and no network: verdicts, and of each scenario the
/// trajectory in its scene, errors over time, pictures, options. Equal reports give equal bytes.
/// Where the bundle is missing it holds verdicts and trajectories alone and says why.
std::string html_report(const std::vector<ScenarioReport>& scenarios,
                        const ReportBundle& bundle = report_bundle());

/// The same as a file. Throws vo::Error as vo::write_file, and when there is no scenario.
void write_html_report(const std::vector<ScenarioReport>& scenarios,
                       const std::filesystem::path& path,
                       vo::ExistingOutput existing = vo::ExistingOutput::keep);

}  // namespace tools
