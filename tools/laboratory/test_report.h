#pragma once

#include <cstddef>
#include <vector>

#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results.h"
#include "tools/pictures/frame_gallery.h"
#include "tools/report/scenario_report.h"

namespace tools {

/// So many pictures of each scenario that a report of all of them stays small enough to be sent.
GalleryOptions pictures_of_each(std::size_t scenarios);

/// What a report shows of every scenario: the means over the seeds with their bounds, the run of
/// the first seed where a trial holds its report, and whatever was wrong.
std::vector<ScenarioReport> test_reports(const TestResults& results,
                                         const std::vector<Change>& changes);

}  // namespace tools
