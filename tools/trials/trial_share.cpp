#include "tools/trials/trial_share.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "tools/report/repeat_command.h"
#include "tools/report/scenario_report.h"
#include "tools/trials/trial_file.h"
#include "vo/core/error.h"
#include "vo/files/unlocked_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// A trial of a test and where its result is.
struct PlannedTrial {
  std::size_t number = 0;
  std::size_t scenario = 0;  ///< index of its scenario
  int seed = 0;
  fs::path file;
};

/// Returns the folder of each scenario's trials: named after it, and after its place among those of
/// the same name if it is not the first.
std::vector<fs::path> scenario_folders(const std::vector<LoadedScenario>& scenarios) {
  std::map<std::string, int> times;
  std::vector<fs::path> folders;
  for (const LoadedScenario& loaded : scenarios) {
    const std::string& name = loaded.result.name;
    const int time = ++times[name];
    folders.emplace_back(time == 1 ? name : vo::concat(name, "~", time));
  }
  return folders;
}

std::vector<PlannedTrial> plan_trials(const std::vector<LoadedScenario>& scenarios,
                                      const fs::path& folder, int seeds) {
  const std::vector<fs::path> folders = scenario_folders(scenarios);
  std::vector<PlannedTrial> trials;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    for (int seed = 0; seed < seeds; ++seed) {
      trials.push_back({.number = trials.size(),
                        .scenario = i,
                        .seed = seed,
                        .file = folder / folders[i] / vo::concat("seed-", seed, ".jsonl")});
    }
  }
  return trials;
}

/// Returns the trial in a file that is there, whatever it was measured with. Throws vo::Error where
/// it is damaged, or of kind output_exists where it has another key.
TrialResult read_planned(const PlannedTrial& planned, const TrialKey& key) {
  TrialFile file = read_trial(planned.file);
  const std::string other = difference(file.key, key);
  if (!other.empty()) {
    vo::fail_as(vo::ErrorKind::output_exists, planned.file.string(), ": was measured with another ",
                other, "; use another folder, or --shard with --again to replace it");
  }
  vo::require(file.trial.seed == planned.seed, planned.file.string(), ": is of seed ",
              file.trial.seed);
  return std::move(file.trial);
}

/// Returns whether a trial need not be run: its file is there, whole, and what it says would be
/// said again.
bool is_done(const PlannedTrial& planned, const TrialKey& key) {
  if (!fs::exists(planned.file)) {
    return false;
  }
  try {
    const TrialResult trial = read_planned(planned, key);
    return trial.problem.empty() || trial.kind != ProblemKind::unusable;
  } catch (const vo::Error& error) {
    if (error.kind() == vo::ErrorKind::output_exists) {
      throw;
    }
    return false;
  }
}

/// The trials of a share that are to be run, and where each will be written.
struct ShareWork {
  ShareOutcome outcome;
  std::vector<TrialJob> jobs;
  std::map<std::size_t, std::pair<fs::path, TrialKey>> places;  ///< by the trials' numbers
};

/// Says once of a scenario why it is unusable.
void add_unusable(const std::string& name, const std::string& problem, ShareOutcome& outcome) {
  const std::string sentence = name + ": " + problem;
  if (outcome.unusable.empty() || outcome.unusable.back() != sentence) {
    outcome.unusable.push_back(sentence);
  }
}

void add_trial(const PlannedTrial& planned, const LoadedScenario& loaded, bool again,
               TrialKeys& keys, ShareWork& work) {
  ++work.outcome.trials;
  if (!loaded.scenario) {
    add_unusable(loaded.result.name, loaded.result.trials.front().problem, work.outcome);
    return;
  }
  TrialKey key;
  try {
    key = keys.key(*loaded.scenario, planned.seed);
  } catch (const vo::Error& error) {
    add_unusable(loaded.result.name, error.what(), work.outcome);
    return;
  }
  if (!again && is_done(planned, key)) {
    ++work.outcome.kept;
    return;
  }
  work.jobs.push_back({*loaded.scenario, planned.seed, planned.number});
  work.places[planned.number] = {planned.file, std::move(key)};
}

/// Writes a trial that has ended, or notes why it is to be run again.
void keep_trial(const TrialJob& job, const TrialResult& trial, vo::Durability durability,
                ShareWork& work) {
  const std::string sentence =
      vo::concat(job.scenario.name, ", seed ", job.seed, ": ", trial.problem);
  const bool is_measured = trial.problem.empty();
  if (!is_measured && trial.kind == ProblemKind::temporary) {
    work.outcome.temporary.push_back(sentence);
    return;
  }
  if (!is_measured && trial.kind == ProblemKind::unusable) {
    work.outcome.unusable.push_back(sentence);
  }
  const auto& [path, key] = work.places.at(job.number);
  write_trial(path, {key, trial}, durability);
}

/// Makes a trial's report say how it is repeated from here, whatever folder the task ran in.
void repeat_from_here(const Scenario& scenario, const RunSettings& settings, TrialResult& trial) {
  if (trial.report) {
    const auto report = std::make_shared<ScenarioReport>(*trial.report);
    report->repeat = settings.trial.tracker ? repeat_test(scenario, settings.trial.tracker->command)
                                            : repeat_run(scenario);
    trial.report = report;
  }
}

/// Returns the trial of a file; empty, and tells what is wrong, where it is missing or damaged.
std::optional<TrialResult> collected(const PlannedTrial& planned, const TrialKey& key,
                                     std::string& problem) {
  if (!fs::exists(planned.file)) {
    return {};
  }
  try {
    return read_planned(planned, key);
  } catch (const vo::Error& error) {
    if (error.kind() == vo::ErrorKind::output_exists) {
      throw;
    }
    problem = vo::concat(" (", error.what(), ")");
    return {};
  }
}

}  // namespace

ShareOutcome run_share(const std::vector<LoadedScenario>& scenarios, const TrialTask& task,
                       const RunSettings& settings, const vo::Progress& progress,
                       const vo::WaitObserver& waiting, const TrialObserver& observe) {
  TrialKeys keys(settings.trial);
  ShareWork work;
  for (const fs::path& folder : scenario_folders(scenarios)) {
    if (fs::is_directory(task.folder.path / folder)) {
      vo::remove_abandoned_unlocked(task.folder.path / folder);
    }
  }
  for (const PlannedTrial& planned : plan_trials(scenarios, task.folder.path, settings.seeds)) {
    if (task.share.takes(planned.number)) {
      add_trial(planned, scenarios[planned.scenario], settings.trial.measure_again, keys, work);
    }
  }
  run_trials(work.jobs, settings, progress, waiting,
             [&](const TrialJob& job, const TrialResult& trial) {
               keep_trial(job, trial, task.folder.durability, work);
               if (observe) {
                 observe(job, trial);
               }
             });
  return std::move(work.outcome);
}

std::vector<std::size_t> CollectedTrials::missing_shares(std::size_t shares) const {
  std::set<std::size_t> numbers;
  for (const MissingTrial& trial : missing) {
    numbers.insert(trial.number % shares + 1);
  }
  return {numbers.begin(), numbers.end()};
}

std::string CollectedTrials::names_of_missing() const {
  constexpr std::size_t kMostNamed = 10;
  std::string names;
  for (std::size_t i = 0; i < std::min(missing.size(), kMostNamed); ++i) {
    names += (i == 0 ? "" : ", ") + missing[i].name;
  }
  return missing.size() <= kMostNamed
             ? names
             : vo::concat(names, " and ", missing.size() - kMostNamed, " more");
}

CollectedTrials collect_trials(const std::vector<LoadedScenario>& scenarios, const fs::path& folder,
                               const RunSettings& settings, const vo::Progress& progress) {
  const std::vector<PlannedTrial> plan = plan_trials(scenarios, folder, settings.seeds);
  TrialKeys keys(settings.trial);
  CollectedTrials all{.trials = {}, .missing = {}, .expected = plan.size()};
  for (const PlannedTrial& planned : plan) {
    const LoadedScenario& loaded = scenarios[planned.scenario];
    progress(planned.number + 1, plan.size());
    if (!loaded.scenario) {
      continue;
    }
    const TrialKey key = keys.key(*loaded.scenario, planned.seed);
    std::string problem;
    if (std::optional<TrialResult> trial = collected(planned, key, problem)) {
      repeat_from_here(*loaded.scenario, settings, *trial);
      all.trials.push_back(std::move(*trial));
    } else {
      all.missing.push_back(
          {planned.number, vo::concat(loaded.result.name, " seed ", planned.seed, problem)});
    }
  }
  return all;
}

}  // namespace tools
