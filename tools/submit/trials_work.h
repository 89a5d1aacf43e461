#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/submit/shared_work.h"
#include "vo/core/progress.h"

namespace tools {

/// The command of edvo whose trials are run.
enum class TrialsCommand { test, sweep };

/// Trials of scenarios to be run by tasks: calls of `edvo test` or `edvo sweep`.
struct TrialsJob {
  std::filesystem::path program;  ///< edvo
  TrialsCommand command = TrialsCommand::test;
  std::vector<std::filesystem::path> scenarios;  ///< files and folders, absolute
  std::filesystem::path out;                     ///< folder of trials/ and the command's results
  std::filesystem::path folder;      ///< in which the tracker's command means what the user means
  std::vector<std::string> options;  ///< further ones, of every call of the command
  int task_jobs = 1;
  int local_jobs = 0;  ///< of the engine `local`; 0 = as many as there are cores
  bool force = false;  ///< whether a table of another sweep is replaced
};

SharedWork trials_work(const TrialsJob& job, std::size_t shares);

/// Returns the shares of which trials are missing, as the command says of what it is to collect.
/// Throws vo::Error where it cannot.
std::vector<std::size_t> missing_shares(const TrialsJob& job, std::size_t shares,
                                        const vo::WaitObserver& waiting);

}  // namespace tools
