#pragma once

#include <string>

#include "vo/sequence_odometry/track_sequence.h"

namespace vo {

/// Returns CSV with one line per frame: stamp, and the time of each stage, ms, which differ from
/// run to run.
std::string format_time_log(const SequenceResult& result);

}  // namespace vo
