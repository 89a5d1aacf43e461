#pragma once

#include <cstdint>

namespace tools {

/// Signals that come this soon after the first, ns, are one request to end: `timeout` sends two at
/// once, and a parent passes on what its group has got already.
inline constexpr std::int64_t kSameRequestNs = 500'000'000;

/// Makes SIGINT, SIGTERM and SIGHUP be recorded instead of ending the process, and a write beyond
/// the file size limit an error of `write` instead of a signal. SIGINT and SIGHUP stay ignored
/// where the process was started with them ignored, as by nohup. A further signal, `kSameRequestNs`
/// or more after the first, ends the process at once. A write into a pipe that nobody reads ends
/// the process by SIGPIPE, whatever its parent ignored.
void remember_signals();

/// Returns whether a signal has been recorded, for what ends well when it is stopped.
bool is_interrupted();

/// Throws vo::Error (`interrupted` after SIGINT, `temporary` after SIGTERM or SIGHUP) once a signal
/// has been recorded.
void throw_if_interrupted();

}  // namespace tools
