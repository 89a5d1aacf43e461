#pragma once

namespace vo {

/// Processor time of this process, ms: what others do on the machine counts little. The tracker
/// works in one thread, so on an idle machine it is the time that passes.
double processor_ms();

}  // namespace vo
