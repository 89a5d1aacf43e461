#pragma once

#include <cstddef>
#include <vector>

#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results.h"
#include "tools/pictures/frame_gallery.h"
#include "tools/report/scenario_report.h"

namespace tools {

/// Returns a picture limit per scenario that keeps a report of all scenarios small enough to send.
GalleryOptions pictures_of_each(std::size_t scenarios);

/// Returns a report per scenario: the metrics' means over the seeds with their bounds, the run of
/// the first seed where its trial holds a report, and every problem and alarm.
std::vector<ScenarioReport> test_reports(const TestResults& results,
                                         const std::vector<Change>& changes);

}  // namespace tools
