#pragma once

#include <vector>

#include "tools/depth/mapping_run.h"
#include "tools/plot/table.h"

namespace tools {

/// Returns a table with a row per frame: counts, then the errors of all subsets.
Table depth_table(const std::vector<MappedFrame>& frames);

/// Returns a table with a row per subset of a frame's hypotheses.
Table error_table(const MapErrors& errors);

}  // namespace tools
