#pragma once

#include <vector>

#include "tools/depth/mapping_run.h"
#include "tools/plot/table.h"

namespace tools {

/// One row a frame: counts, then errors of all subsets.
Table depth_table(const std::vector<MappedFrame>& frames);

/// One row a subset of a frame's hypotheses.
Table error_table(const MapErrors& errors);

}  // namespace tools
