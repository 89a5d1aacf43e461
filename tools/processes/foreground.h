#pragma once

#include "tools/processes/child_process.h"
#include "vo/core/progress.h"

namespace tools {

/// Runs a program whose input and output are this process' own, as a shell does; returns its exit
/// code, 128 + signal where one ended it. When `waiting`, which is called repeatedly, throws, the
/// program gets SIGTERM, and what was thrown is thrown again when it has ended. The command's view
/// is not used. Throws vo::Error when the program cannot be started.
int run_in_foreground(const ChildCommand& command, const vo::WaitObserver& waiting);

}  // namespace tools
