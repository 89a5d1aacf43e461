#pragma once

#include <filesystem>
#include <string>

#include "tools/processes/file_lock.h"

namespace tools {

/// How a command of the shell ended.
struct ChildEnd {
  int exit_code = 0;
  int signal = 0;  ///< that ended it; 0 = it ended by itself
  bool timed_out = false;
};

/// Runs `/bin/sh -c command` in a process group of its own, what it prints going into a file, and
/// ends the whole group after `time_limit` seconds or when it returns. `waiting` is told again and
/// again; the group is also ended when it throws. Throws vo::Error when nothing can be started.
ChildEnd run_child(const std::string& command, const std::filesystem::path& output,
                   double time_limit, const WaitObserver& waiting);

/// The text as one word of a shell's command.
std::string shell_quoted(const std::string& text);

}  // namespace tools
