#pragma once

#include <string>

#include "tools/processes/child_process.h"
#include "vo/core/progress.h"

namespace tools {

/// What a program printed until it ended.
struct Printed {
  int exit_code = 0;  ///< as a shell has it: 128 + signal where one ended it
  std::string out;    ///< all of stdout
  std::string err;    ///< the end of stderr, at most 4096 bytes
};

/// Runs a program and reads what it prints. Throws vo::Error as `run_child` does; of a program that
/// is not there the exit code is 127.
Printed run_and_read(const ChildCommand& command, const vo::WaitObserver& waiting);

/// Returns whether a program of this name is in PATH.
bool is_in_path(const std::string& program);

}  // namespace tools
