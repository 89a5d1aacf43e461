#pragma once

#include <vector>

#include "tools/depth/mapping_run.h"
#include "tools/pipeline/track_mono.h"

namespace tools {

/// Tracks and maps a sequence as `edvo track --mode mono` does and compares the map with the true
/// depth of its anchor after each frame. Where the bootstrap is not metric, depths are divided by
/// the median scale of each frame first; the scale over time shows its drift.
std::vector<MappedFrame> track_and_judge(const MonoInput& input, const vo::MonoOptions& options,
                                         const MapObserver& observe, const vo::Progress& progress);

/// Whether the bootstrap's depths are metres.
bool is_metric(vo::MonoBootstrap bootstrap);

}  // namespace tools
