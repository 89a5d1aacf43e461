#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "vo/core/progress.h"

namespace tools {

/// Slurm's queue, as its programs sbatch, squeue and scontrol speak for it. Each call asks once.
class SlurmQueue {
 public:
  /// Throws vo::Error where sbatch is not in PATH. `waiting` is called while a program runs.
  explicit SlurmQueue(vo::WaitObserver waiting);

  /// Returns MaxArraySize: the index of every task of an array is less. Throws vo::Error where the
  /// queue does not answer.
  std::size_t max_array_size() const;

  /// Returns whether a job is waiting or running; one that the queue has forgotten is neither.
  /// Throws vo::Error where the queue does not answer.
  bool is_queued(const std::string& id) const;

  /// Submits a job by these words, `sbatch --parsable ...`, in a folder; returns the job's id.
  /// Throws vo::Error with what sbatch says.
  std::string submit(const std::vector<std::string>& words,
                     const std::filesystem::path& folder) const;

 private:
  vo::WaitObserver waiting_;
};

}  // namespace tools
