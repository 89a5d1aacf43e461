#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tools {

/// Which of the tasks that divide some work this process is.
struct TaskShare {
  std::size_t task = 1;  ///< 1 to `tasks`
  std::size_t tasks = 1;
};

/// Returns the value of an environment variable, null if there is none.
using Environment = std::function<const char*(const char* name)>;

const char* environment_variable(const char* name);

/// Returns the share that `--shard K/N` says; without it, of `--shards N` the one whose number a
/// queue gave to this task of an array: SLURM_ARRAY_TASK_ID, SGE_TASK_ID, PBS_ARRAY_INDEX, of
/// arrays that count from 1, or Kubernetes' JOB_COMPLETION_INDEX, from 0; without both all. The
/// number is never counted from the array's least, because an array of the shares that are missing
/// has another one. Throws vo::Error of kind usage.
TaskShare chosen_share(const std::string& shard, std::size_t shards,
                       const Environment& environment = environment_variable);

/// Returns ascending numbers as arrays of tasks are submitted, "2,5-7".
std::string array_text(const std::vector<std::size_t>& numbers);

}  // namespace tools
