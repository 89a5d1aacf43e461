#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "tools/laboratory/results.h"
#include "tools/trials/trial.h"
#include "vo/core/progress.h"

namespace tools {

struct RunSettings {
  TrialSettings trial;
  BoundsSource bounds = BoundsSource::scenario;
  int seeds = 1;
  int jobs = 1;  ///< number of trials that run concurrently

  void validate() const;  ///< throws vo::Error on an invalid setting
};

enum class SlowScenarios { leave_out, include };

/// Returns the scenario files that the paths name, and those of folders sorted by name, slow ones
/// only if included. Throws vo::Error naming a missing path, a folder without scenarios or two
/// different files of one name, which is a usage error.
std::vector<std::filesystem::path> find_scenarios(const std::vector<std::filesystem::path>& paths,
                                                  SlowScenarios slow);

/// A scenario file and what becomes of it.
struct LoadedScenario {
  ScenarioResult result;             ///< one trial with a problem if the file is unusable
  std::optional<Scenario> scenario;  ///< empty if the file is unusable
};

/// Loads scenario files. One that lacks the bounds that are to judge it is unusable, too.
std::vector<LoadedScenario> load_scenarios(const std::vector<std::filesystem::path>& files,
                                           BoundsSource bounds);

/// Returns the results of scenarios whose trials are `trials`: of each usable scenario those of all
/// seeds, in order. Checks the means against the bounds if the scenario's judge.
TestResults judge_trials(std::vector<LoadedScenario> scenarios, std::vector<TrialResult> trials,
                         const RunSettings& settings);

/// One scenario and one seed to run it with.
struct TrialJob {
  Scenario scenario;
  int seed = 0;
  std::size_t number = 0;  ///< by which its giver knows it again
};

/// Returns a job for each usable scenario and seed, in order.
std::vector<TrialJob> trial_jobs(const std::vector<LoadedScenario>& scenarios, int seeds);

/// Called with each trial when it has ended, in this process.
using TrialObserver = std::function<void(const TrialJob& job, const TrialResult& result)>;

/// Returns the results in job order. Each trial runs in a process of its own, forked from this one,
/// which may have no other thread: a crash costs one trial. `progress` counts trials; `waiting` is
/// called repeatedly, in this process and in those of the trials.
std::vector<TrialResult> run_trials(const std::vector<TrialJob>& jobs, const RunSettings& settings,
                                    const vo::Progress& progress, const vo::WaitObserver& waiting,
                                    const TrialObserver& observe = {});

/// Runs every scenario with every seed and judges them.
TestResults run_tests(const std::vector<std::filesystem::path>& files, const RunSettings& settings,
                      const vo::Progress& progress, const vo::WaitObserver& waiting,
                      const TrialObserver& observe = {});

}  // namespace tools
