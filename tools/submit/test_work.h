#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/submit/shared_work.h"
#include "vo/core/progress.h"

namespace tools {

/// Trials of scenarios to be run by tasks: calls of `edvo test`.
struct TestJob {
  std::filesystem::path program;                 ///< edvo
  std::vector<std::filesystem::path> scenarios;  ///< files and folders, absolute
  std::filesystem::path out;         ///< folder of trials/, results.json, junit.xml and report.html
  std::filesystem::path folder;      ///< in which the tracker's command means what the user means
  std::vector<std::string> options;  ///< further ones of `edvo test`, of every call of it
  int task_jobs = 1;
  int local_jobs = 0;  ///< of the engine `local`; 0 = as many as there are cores
};

SharedWork test_work(const TestJob& job, std::size_t shares);

/// Returns the shares of which trials are missing, as `edvo test --collect` says. Throws vo::Error
/// where it cannot.
std::vector<std::size_t> missing_shares(const TestJob& job, std::size_t shares,
                                        const vo::WaitObserver& waiting);

}  // namespace tools
