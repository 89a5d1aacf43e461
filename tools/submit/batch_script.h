#pragma once

#include <string>
#include <vector>

#include "tools/submit/shared_work.h"
#include "tools/submit/shares.h"

namespace tools {

/// What Slurm is asked for.
struct BatchOptions {
  int cpus = 1;                     ///< of each task
  int memory = 2000;                ///< MB, of each task
  int minutes = 0;                  ///< time limit of each task; 0 = the partition's
  std::size_t throttle = 0;         ///< tasks at once; 0 = as many as there is room for
  std::size_t max_array = 0;        ///< MaxArraySize; 0 = as `scontrol show config` says
  std::vector<std::string> others;  ///< further options of sbatch

  void validate() const;  ///< throws vo::Error if out of range
};

/// Returns the batch script of an array, `name` its file without ending: its tasks make one share
/// each. Its options hold no text of the user's, whose words are quoted in what follows.
std::string array_script(const SharedWork& work, const ArrayChunk& chunk, const std::string& name,
                         const BatchOptions& options);

/// Returns the batch script of the job that puts together what the tasks made.
std::string finish_script(const SharedWork& work, const BatchOptions& options);

}  // namespace tools
