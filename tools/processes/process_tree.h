#pragma once

#include <vector>

#include <sys/types.h>

namespace tools {

/// Returns the processes that descend from `root`, without itself, as far as /proc tells.
std::vector<pid_t> descendants_of(pid_t root);

/// Returns the private resident memory of the processes together, bytes. Pages of files and shared
/// memory are left out.
double private_memory(const std::vector<pid_t>& processes);

/// Kills all descendants of this process, those included that daemonised where this process is
/// their subreaper (PR_SET_CHILD_SUBREAPER), and waits until none is left. Gives up after
/// `time_limit` seconds, for a process in an uninterruptible system call cannot be killed.
void end_descendants(double time_limit);

}  // namespace tools
