#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "vo/core/progress.h"

namespace tools {

/// How the process of a job ended.
struct JobEnd {
  std::string result;  ///< what the job returned; not all of it unless `is_complete()`
  int signal = 0;      ///< signal that ended the process; 0 = none
  int exit_code = 0;   ///< 0 when the job returned, 1 when it threw

  bool is_complete() const { return signal == 0 && exit_code == 0; }
};

/// What to do with jobs: `work` returns a job's result, in a process of its own, and `done` is told
/// in this process how that ended.
struct ForkedJobs {
  std::function<std::string(std::size_t)> work;
  std::function<void(std::size_t, JobEnd)> done;
};

/// Runs the jobs 0 to count - 1, each in a process forked from this one, at most `jobs` at a time,
/// so that one that crashes costs its own result alone. `waiting` is called repeatedly; when it
/// throws, or when this process ends, the jobs are sent SIGTERM, and SIGKILL if they are still
/// there after some seconds. To be called while this process has one thread, for a fork has no
/// others.
void run_forked(std::size_t count, int jobs, const ForkedJobs& what,
                const vo::WaitObserver& waiting);

}  // namespace tools
