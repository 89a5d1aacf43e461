#pragma once

namespace vo {

/// Returns the processor time of this process, ms, which other processes hardly affect. The tracker
/// works in one thread, so on an idle machine it is the time that passes.
double processor_ms();

}  // namespace vo
