#include "tools/trials/trial.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "tools/processes/readable_text.h"
#include "tools/report/scenario_report.h"
#include "tools/sequence_cache/sequence_cache.h"
#include "tools/trials/trial_file.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/sequence.h"
#include "vo/files/input.h"
#include "vo/files/system_failure.h"
#include "vo/hashing/content_hash.h"
#include "vo/text_files/toml_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;

constexpr double kUnknownMetric = std::numeric_limits<double>::quiet_NaN();

/// Returns the cache key of edvo's own result on a sequence.
std::string kept_key(const Scenario& scenario, const std::string& sequence) {
  Scenario copy = scenario;
  const char* runs = scenario.expect.contains("repeat_difference_m") ? "twice" : "once";
  return vo::content_hash(vo::concat(
      program_hash(), "\n", sequence, "\n", vo::format_toml(vo::fields_of(copy.odometry)), "\n",
      vo::format_toml(vo::fields_of(copy.score)), "\n", runs, "\n", forest_models_hash(scenario)));
}

/// Returns the key of a kept result as its file states it.
TrialKey key_of_kept(const std::string& key) {
  return {{"run", key}};
}

/// Returns what another run with the same key would measure, too: no remark, no report.
TrialResult what_is_kept(const TrialResult& trial) {
  return {.seed = trial.seed,
          .sequence = trial.sequence,
          .frames = trial.frames,
          .metrics = trial.metrics};
}

/// Returns the cached result of an earlier run; empty where there is no file, or one that is
/// damaged or of another run.
std::optional<TrialResult> read_kept(const fs::path& file, const std::string& key) {
  if (!fs::exists(file)) {
    return {};
  }
  try {
    TrialFile kept = read_trial(file);
    return kept.key == key_of_kept(key) ? std::optional(std::move(kept.trial)) : std::nullopt;
  } catch (const vo::Error&) {
    return {};
  }
}

void set_problem(TrialResult& trial, ProblemKind kind, const std::string& sentence) {
  trial.problem = readable_text(sentence);
  trial.kind = kind;
}

bool is_reported(const TrialSettings& settings, const TrialResult& trial) {
  return settings.pictures && trial.seed == 0;
}

void add_report(const Scenario& scenario, const Outcome& outcome, FrameGallery gallery,
                TrialResult& trial) {
  const auto report = std::make_shared<ScenarioReport>(scenario_report(scenario, outcome));
  report->gallery = std::move(gallery);
  trial.report = report;
}

void measure_outside(const Scenario& scenario, const TrialSettings& settings,
                     const fs::path& folder, const vo::WaitObserver& waiting, TrialResult& trial) {
  const vo::SequenceReader sequence(folder);
  const auto content = scenario.odometry.mode == OdometryMode::rgbd
                           ? vo::SequenceContent::colour_and_depth
                           : vo::SequenceContent::colour;
  OutsideRun run = track_outside(*settings.tracker, folder, content, sequence, waiting);
  if (!run.problem.empty()) {
    set_problem(trial, run.kind, run.problem);
    return;
  }
  Outcome outcome{
      .tracking = std::move(run.tracking), .truth = sequence.ground_truth(), .metrics = {}};
  outcome.metrics = without_own_judgement(measure(outcome.truth, outcome.tracking, scenario.score));
  outcome.metrics.keyframes = kUnknownMetric;
  trial.metrics = outcome.metrics;
  if (is_reported(settings, trial)) {
    trial.report = std::make_shared<ScenarioReport>(
        outside_report(scenario, outcome, settings.tracker->command));
  }
}

/// Tracks the sequence, adds a report with pictures to the trial and returns the metrics.
Metrics reported(const Scenario& scenario, const vo::SequenceReader& sequence,
                 const GalleryOptions& pictures, const vo::Progress& progress, TrialResult& trial) {
  FrameGallery gallery(pictures);
  const Outcome outcome =
      track_scenario(scenario, sequence, {.frame = gallery.observer(), .map = {}}, progress);
  add_report(scenario, outcome, std::move(gallery), trial);
  return outcome.metrics;
}

void measure_trial(const Scenario& scenario, const TrialSettings& settings,
                   const vo::WaitObserver& waiting, TrialResult& trial) {
  const vo::Progress progress = [&](std::size_t, std::size_t) { waiting(); };
  const CachedSequence cached =
      cached_sequence(settings.cache, render_job(with_seed(scenario, trial.seed)), progress);
  trial.sequence = cached.content;
  if (!cached.problem.empty()) {
    trial.note = vo::concat("the cache's ", cached.folder.filename().string(),
                            " was rendered again: ", cached.problem);
  }
  const vo::SequenceReader sequence(cached.folder);
  trial.frames = sequence.size();
  if (settings.tracker) {
    measure_outside(scenario, settings, cached.folder, waiting, trial);
    return;
  }
  const std::string key = kept_key(scenario, cached.content);
  const fs::path file = settings.cache / "results" / (key + ".jsonl");
  const vo::FileLock lock(settings.cache / "locks" / key, vo::LockKind::exclusive, waiting);
  const bool again = settings.measure_again || is_reported(settings, trial);
  const std::optional<TrialResult> kept = again ? std::nullopt : read_kept(file, key);
  if (kept) {
    trial.metrics = kept->metrics;
    trial.was_kept = true;
    return;
  }
  trial.metrics = is_reported(settings, trial)
                      ? reported(scenario, sequence, *settings.pictures, progress, trial)
                      : track_scenario(scenario, sequence, {}, progress).metrics;
  write_trial(file, {key_of_kept(key), what_is_kept(trial)}, vo::Durability::unsynced);
}

}  // namespace

const std::string& program_hash() {
  static const std::string hash = vo::content_hash(vo::read_file("/proc/self/exe"));
  return hash;
}

TrialResult run_trial(const Scenario& scenario, int seed, const TrialSettings& settings,
                      const vo::WaitObserver& waiting) {
  const Clock::time_point start = Clock::now();
  TrialResult trial{.seed = seed};
  trial.metrics = make_metrics([](const std::string&) { return kUnknownMetric; });
  try {
    measure_trial(scenario, settings, waiting, trial);
  } catch (const vo::Error& error) {
    waiting();
    set_problem(
        trial,
        error.kind() == vo::ErrorKind::temporary ? ProblemKind::temporary : ProblemKind::unusable,
        error.what());
  } catch (const fs::filesystem_error& error) {
    waiting();
    const bool is_temporary = vo::kind_of_failure(error.code().value()) == vo::ErrorKind::temporary;
    set_problem(trial, is_temporary ? ProblemKind::temporary : ProblemKind::unusable,
                error.path1().string() + ": " + error.code().message());
  } catch (const std::bad_alloc&) {
    set_problem(trial, ProblemKind::temporary, "out of memory");
  } catch (const std::exception& error) {
    set_problem(trial, ProblemKind::crash, vo::concat("internal error: ", error.what()));
  }
  trial.time = std::chrono::duration<double>(Clock::now() - start).count();
  return trial;
}

}  // namespace tools
