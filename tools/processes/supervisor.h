#pragma once

#include "tools/processes/child_process.h"

namespace tools {

/// The fixed part of what a supervisor tells of its child's end; the tail of its output follows.
struct SupervisorMessage {
  int start_error = 0;  ///< errno of what kept the program from starting; 0 = it started
  int exit_code = 0;
  int signal = 0;
  ExceededLimit exceeded = ExceededLimit::none;
};

/// The life of a supervisor, a process of its own between the one that wants a program run and the
/// program: it starts the program, adopts what that daemonises, watches limits, kills all of it
/// when the program ends or the other end of the socket `control` is closed, and writes its message
/// there. Called in a forked process, which it ends.
[[noreturn]] void supervise(const ChildCommand& command, const ChildLimits& limits, int control);

}  // namespace tools
