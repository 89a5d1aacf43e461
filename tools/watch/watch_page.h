#pragma once

#include <string>

#include "tools/report/report_bundle.h"

namespace tools {

/// Version of what the page of a run is told; a changed meaning or a removed member needs a new
/// one.
constexpr int kLiveVersion = 1;

/// Returns the HTML of the page that shows a run while it runs; where the bundle is missing, one
/// that says why it shows nothing.
std::string watch_page(const ReportBundle& bundle = report_bundle());

}  // namespace tools
