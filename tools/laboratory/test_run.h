#pragma once

#include <filesystem>
#include <vector>

#include "tools/laboratory/results.h"
#include "tools/laboratory/trial.h"
#include "vo/core/progress.h"

namespace tools {

struct RunSettings {
  TrialSettings trial;
  int seeds = 1;
  int jobs = 1;  ///< trials at a time

  void validate() const;  ///< throws vo::Error
};

enum class SlowScenarios { leave_out, include };

/// The scenario files that paths name, by name: files themselves, and those of folders without the
/// slow ones. Throws vo::Error naming a path that is not there or a folder without scenarios.
std::vector<std::filesystem::path> find_scenarios(const std::vector<std::filesystem::path>& paths,
                                                  SlowScenarios slow);

/// One of many trials.
struct TrialJob {
  Scenario scenario;
  int seed = 0;
};

/// In the order of the jobs, however they were done. `progress` counts trials, `waiting` is told
/// again and again, from several threads at once.
std::vector<TrialResult> run_trials(const std::vector<TrialJob>& jobs, const RunSettings& settings,
                                    const vo::Progress& progress, const WaitObserver& waiting);

/// Every scenario with every seed, judged. A file that cannot be used is a scenario with a problem.
TestResults run_tests(const std::vector<std::filesystem::path>& files, const RunSettings& settings,
                      const vo::Progress& progress, const WaitObserver& waiting);

}  // namespace tools
