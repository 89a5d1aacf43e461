#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/submit/shared_work.h"
#include "vo/core/progress.h"

namespace tools {

/// A data set to be made by tasks: calls of `edvo dataset`, with paths that do not depend on the
/// folder they run in.
struct DatasetJob {
  std::filesystem::path program;  ///< edvo
  std::filesystem::path spec;
  std::filesystem::path out;
  int task_threads = 1;
  int local_threads = 0;  ///< of the engine `local`; 0 = all cores
};

/// What `edvo dataset plan` says of it.
struct DatasetSize {
  std::size_t parts = 0;
  double processor_s = 0;  ///< s, of all parts together
};

SharedWork dataset_work(const DatasetJob& job, std::size_t shares);

/// Plans a data set, and keeps the plan where its tasks find it, if so asked. Throws vo::Error with
/// what `edvo dataset plan` says of a spec that cannot be used or was changed.
enum class KeepPlan { no, yes };
DatasetSize plan_dataset(const DatasetJob& job, KeepPlan keep, const vo::WaitObserver& waiting);

/// Returns how many shares take a task ten minutes, at most one for each part.
std::size_t shares_for(const DatasetSize& size, int task_threads);

/// Returns the shares that miss something, as `edvo dataset status` says. Throws vo::Error
/// likewise.
std::vector<std::size_t> missing_shares(const DatasetJob& job, std::size_t shares,
                                        const vo::WaitObserver& waiting);

}  // namespace tools
