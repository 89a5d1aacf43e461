#pragma once

#include <string>
#include <vector>

#include "tools/depth/mapping_run.h"

namespace tools {

/// Returns an SVG of a depth map over time: the change of its scale since the first frame, the
/// median error, and the number of hypotheses.
std::string draw_course(const std::vector<MappedFrame>& frames);

}  // namespace tools
