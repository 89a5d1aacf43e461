#pragma once

#include <string>
#include <vector>

#include "tools/depth/mapping_run.h"

namespace tools {

/// A map over time as SVG: by how much its scale has changed since the first frame, the median
/// error, and how many hypotheses it holds.
std::string draw_course(const std::vector<MappedFrame>& frames);

}  // namespace tools
