#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tools/processes/private_view.h"
#include "vo/core/progress.h"

namespace tools {

/// A program to run as a child process, without a shell.
struct ChildCommand {
  std::vector<std::string> words;  ///< the program, looked up in PATH, and its arguments
  std::optional<std::vector<std::string>> environment{};  ///< NAME=value; this process' if empty
  std::filesystem::path folder{};  ///< working folder; this process' if empty
  PrivateView view{};
};

/// Limits of a child process and of all that it starts. Only `file` is kept by the system itself;
/// the others are watched, so that they may be exceeded for a tenth of a second.
struct ChildLimits {
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  double time = kNone;       ///< wall time, s
  double memory = kNone;     ///< private resident memory of all processes together, bytes
  double processes = kNone;  ///< number of processes at a time
  double output = kNone;     ///< what all print together, bytes
  double file = kNone;       ///< size of each file written, bytes (RLIMIT_FSIZE)
};

/// The limit at which a child process was ended.
enum class ExceededLimit { none, time, memory, processes, output };

/// How a child process ended.
struct ChildEnd {
  int exit_code = 0;
  int signal = 0;  ///< signal that ended it; 0 = it exited by itself
  ExceededLimit exceeded = ExceededLimit::none;
  std::string tail;  ///< last bytes that were printed, at most 4096
};

/// Runs a program with its output (stdout and stderr) read and all but its tail forgotten. When it
/// ends, when it exceeds a limit, when `waiting`, which is called repeatedly, throws, or when this
/// process ends in whatever way, all that it started is killed, daemons included. Throws vo::Error
/// when the program cannot be started.
ChildEnd run_child(const ChildCommand& command, const ChildLimits& limits,
                   const vo::WaitObserver& waiting);

}  // namespace tools
