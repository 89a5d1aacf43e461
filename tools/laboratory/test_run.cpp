#include "tools/laboratory/test_run.h"

#include <algorithm>
#include <mutex>
#include <optional>

#include "tools/processes/job_pool.h"
#include "tools/processes/readable_text.h"
#include "vo/core/error.h"
#include "vo/core/version.h"
#include "vo/files/toml_file.h"

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
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const bool is_scenario = entry.path().extension() == ".toml" && entry.is_regular_file();
    if (is_scenario && (slow == SlowScenarios::include || !is_slow(entry.path()))) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  vo::require(!files.empty(), folder.string(), ": has no scenario, expected .toml files");
  return files;
}

/// A scenario file's result and, if it could be loaded, its scenario.
struct LoadedScenario {
  ScenarioResult result;
  std::optional<Scenario> scenario;  ///< empty if the file is unusable
};

LoadedScenario load(const fs::path& file, BoundsSource bounds) {
  LoadedScenario loaded{.result = {.name = file.stem().string()}, .scenario = {}};
  try {
    Scenario scenario = load_scenario(file);
    scenario.require_scene();
    vo::require(bounds != BoundsSource::scenario || !scenario.expect.empty(), file.string(),
                ": expect: expected at least one bound, or --bounds baseline or none");
    loaded.result.why = scenario.why;
    loaded.scenario = std::move(scenario);
  } catch (const vo::Error& error) {
    loaded.result.trials.push_back({.problem = readable_text(error.what())});
  }
  return loaded;
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
  return files;
}

std::vector<TrialResult> run_trials(const std::vector<TrialJob>& jobs, const RunSettings& settings,
                                    const vo::Progress& progress, const WaitObserver& waiting) {
  std::vector<TrialResult> results(jobs.size());
  std::mutex mutex;
  std::size_t done = 0;
  run_jobs(jobs.size(), settings.jobs, [&](std::size_t i) {
    results[i] = run_trial(jobs[i].scenario, jobs[i].seed, settings.trial, waiting);
    const std::lock_guard lock(mutex);
    progress(++done, jobs.size());
  });
  return results;
}

TestResults run_tests(const std::vector<fs::path>& files, const RunSettings& settings,
                      const vo::Progress& progress, const WaitObserver& waiting) {
  std::vector<LoadedScenario> scenarios;
  std::vector<TrialJob> jobs;
  for (const fs::path& file : files) {
    scenarios.push_back(load(file, settings.bounds));
    for (int seed = 0; scenarios.back().scenario && seed < settings.seeds; ++seed) {
      jobs.push_back({*scenarios.back().scenario, seed});
    }
  }
  std::vector<TrialResult> trials = run_trials(jobs, settings, progress, waiting);
  TestResults results{.edvo = vo::version(),
                      .tracker = settings.trial.tracker ? settings.trial.tracker->command : "edvo",
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

}  // namespace tools
