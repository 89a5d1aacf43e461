#include "tools/trials/test_run.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include <tbb/global_control.h>

#include "tools/processes/forked_jobs.h"
#include "tools/processes/readable_text.h"
#include "tools/processes/scratch_folder.h"
#include "tools/trials/trial_message.h"
#include "vo/core/error.h"
#include "vo/core/version.h"
#include "vo/files/folder.h"
#include "vo/text_files/toml_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// Returns whether the file says `slow = true`; an unusable file is found when it is run.
bool is_slow(const fs::path& file) {
  try {
    const std::vector<vo::TomlValue> values = vo::read_toml(file);
    return std::any_of(values.begin(), values.end(), [](const vo::TomlValue& value) {
      return value.key == "slow" && value.text == "true";
    });
  } catch (const vo::Error&) {
    return false;
  }
}

std::vector<fs::path> scenarios_in(const fs::path& folder, SlowScenarios slow) {
  std::vector<fs::path> files;
  for (const vo::FolderEntry& entry : vo::entries_of(folder)) {
    const fs::path file = folder / entry.name;
    const bool is_scenario = file.extension() == ".toml" && fs::is_regular_file(file);
    if (is_scenario && (slow == SlowScenarios::include || !is_slow(file))) {
      files.push_back(file);
    }
  }
  vo::require(!files.empty(), folder.string(), ": has no scenario, expected .toml files");
  return files;
}

/// Throws where two scenarios have one name, by which their results would be mixed.
void require_distinct_names(const std::vector<fs::path>& files) {
  std::map<std::string, fs::path> named;
  for (const fs::path& file : files) {
    const auto [first, is_new] = named.try_emplace(file.stem().string(), file);
    if (!is_new && !fs::equivalent(first->second, file)) {
      vo::fail_as(vo::ErrorKind::usage, file.string(), ": has the name of ", first->second.string(),
                  ", expected scenarios of different names");
    }
  }
}

LoadedScenario load(const fs::path& file, BoundsSource bounds) {
  LoadedScenario loaded{.result = {.name = readable_text(file.stem().string())}, .scenario = {}};
  try {
    Scenario scenario = load_scenario(file);
    scenario.require_scene();
    vo::require(bounds != BoundsSource::scenario || !scenario.expect.empty(), file.string(),
                ": expect: expected at least one bound, or --bounds baseline or none");
    loaded.result.why = scenario.why;
    loaded.scenario = std::move(scenario);
  } catch (const vo::Error& error) {
    loaded.result.trials.push_back({.problem = readable_text(error.what())});
  } catch (const fs::filesystem_error& error) {
    loaded.result.trials.push_back({.problem = readable_text(error.what())});
  }
  return loaded;
}

/// Makes a trial's process put its temporary files into a folder that outlives it, and take its
/// share of the threads: twice what is its own, because trials differ in how long they take.
tbb::global_control prepare_process(const fs::path& scratch, int at_a_time) {
  using tbb::global_control;
  ::setenv("TMPDIR", scratch.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): a process of one thread
  const std::size_t all = global_control::active_value(global_control::max_allowed_parallelism);
  const std::size_t share = 2 * all / static_cast<std::size_t>(std::max(at_a_time, 1));
  return {global_control::max_allowed_parallelism, std::clamp<std::size_t>(share, 1, all)};
}

}  // namespace

void RunSettings::validate() const {
  constexpr int kMaxSeeds = 10000;
  vo::require(seeds >= 1 && seeds <= kMaxSeeds, "--seeds: expected 1 to ", kMaxSeeds, ", got ",
              seeds);
  vo::require(jobs >= 1, "--jobs: expected at least 1, got ", jobs);
  if (trial.tracker) {
    trial.tracker->validate();
  }
}

std::vector<fs::path> find_scenarios(const std::vector<fs::path>& paths, SlowScenarios slow) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths) {
    if (fs::is_directory(path)) {
      const std::vector<fs::path> found = scenarios_in(path, slow);
      files.insert(files.end(), found.begin(), found.end());
    } else {
      vo::require(fs::exists(path), path.string(), ": there is no such file");
      files.push_back(path);
    }
  }
  require_distinct_names(files);
  return files;
}

std::vector<LoadedScenario> load_scenarios(const std::vector<fs::path>& files,
                                           BoundsSource bounds) {
  std::vector<LoadedScenario> scenarios;
  for (const fs::path& file : files) {
    scenarios.push_back(load(file, bounds));
  }
  return scenarios;
}

TestResults judge_trials(std::vector<LoadedScenario> scenarios, std::vector<TrialResult> trials,
                         const RunSettings& settings) {
  TestResults results{
      .edvo = vo::version(),
      .tracker = settings.trial.tracker ? readable_text(settings.trial.tracker->command) : "edvo",
      .bounds = settings.bounds,
      .scenarios = {}};
  auto next = trials.begin();
  for (LoadedScenario& loaded : scenarios) {
    ScenarioResult& result = loaded.result;
    if (loaded.scenario) {
      const auto end = next + settings.seeds;
      result.trials.assign(std::make_move_iterator(next), std::make_move_iterator(end));
      next = end;
      const auto& expect = loaded.scenario->expect;
      if (result.verdict() != Verdict::error && settings.bounds == BoundsSource::scenario) {
        result.checks =
            check_means(result, settings.trial.tracker ? outside_bounds(expect) : expect);
      }
    }
    results.scenarios.push_back(std::move(result));
  }
  return results;
}

std::vector<TrialJob> trial_jobs(const std::vector<LoadedScenario>& scenarios, int seeds) {
  std::vector<TrialJob> jobs;
  for (const LoadedScenario& loaded : scenarios) {
    for (int seed = 0; loaded.scenario && seed < seeds; ++seed) {
      jobs.push_back({*loaded.scenario, seed});
    }
  }
  return jobs;
}

std::vector<TrialResult> run_trials(const std::vector<TrialJob>& jobs, const RunSettings& settings,
                                    const vo::Progress& progress, const vo::WaitObserver& waiting,
                                    const TrialObserver& observe) {
  program_hash();  // once for the processes of all trials
  const ScratchFolder scratch;
  const int at_a_time = std::min(settings.jobs, static_cast<int>(jobs.size()));
  std::vector<TrialResult> results(jobs.size());
  std::size_t done = 0;
  const auto work = [&](std::size_t i) {
    const auto limit = prepare_process(scratch.path(), at_a_time);
    return trial_message(run_trial(jobs[i].scenario, jobs[i].seed, settings.trial, waiting));
  };
  const auto take = [&](std::size_t i, const JobEnd& end) {
    waiting();
    results[i] = trial_of_process(end, jobs[i].seed);
    if (observe) {
      observe(jobs[i], results[i]);
    }
    progress(++done, jobs.size());
  };
  run_forked(jobs.size(), settings.jobs, {.work = work, .done = take}, waiting);
  return results;
}

TestResults run_tests(const std::vector<fs::path>& files, const RunSettings& settings,
                      const vo::Progress& progress, const vo::WaitObserver& waiting,
                      const TrialObserver& observe) {
  std::vector<LoadedScenario> scenarios = load_scenarios(files, settings.bounds);
  std::vector<TrialResult> trials =
      run_trials(trial_jobs(scenarios, settings.seeds), settings, progress, waiting, observe);
  return judge_trials(std::move(scenarios), std::move(trials), settings);
}

}  // namespace tools
