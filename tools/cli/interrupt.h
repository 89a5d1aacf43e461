#pragma once

namespace tools {

/// From here on SIGINT, SIGTERM and SIGHUP are remembered instead of ending the process, and a file
/// that grows beyond its limit is an error of `write` instead of a signal.
void remember_signals();

/// Throws vo::Error (`interrupted` after SIGINT, `temporary` after the others) once a signal came.
void throw_if_interrupted();

}  // namespace tools
