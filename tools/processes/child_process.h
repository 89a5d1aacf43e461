#pragma once

#include <filesystem>
#include <string>

#include "tools/processes/file_lock.h"

namespace tools {

/// How a shell command ended.
struct ChildEnd {
  int exit_code = 0;
  int signal = 0;  ///< signal that ended it; 0 = it exited by itself
  bool timed_out = false;
};

/// Runs `/bin/sh -c command` in its own process group with its output redirected to a file, and
/// kills the group after `time_limit` seconds and on return. `waiting` is called repeatedly; the
/// group is also killed when it throws. Throws vo::Error when the command cannot be started.
ChildEnd run_child(const std::string& command, const std::filesystem::path& output,
                   double time_limit, const WaitObserver& waiting);

/// Returns the text quoted as one word of a shell command.
std::string shell_quoted(const std::string& text);

}  // namespace tools
