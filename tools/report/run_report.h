#pragma once

#include <filesystem>

#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "vo/files/output.h"

namespace tools {

struct RunReportOptions {
  int debug_images = 30;  ///< a picture of every n-th frame; 0 = none
  bool times = false;     ///< times of each stage in report.html, which then differs between runs
};

/// Renders a scenario's sequence into `folder`, tracks it and writes what `edvo run` leaves there:
/// reports, trajectory, frames and pictures. `watching` is told of each frame, too. Throws
/// vo::Error where the folder holds other files.
Outcome run_and_report(const Scenario& scenario, const std::filesystem::path& folder,
                       const vo::OutputPolicy& policy, const RunReportOptions& options,
                       const RunProgress& progress, const ScenarioObservers& watching = {});

}  // namespace tools
