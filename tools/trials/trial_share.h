#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/trials/test_run.h"
#include "vo/core/progress.h"
#include "vo/files/output.h"

namespace tools {

/// Which of many trials one of several tasks runs: every `shares`-th, so that the seeds of a
/// scenario that takes long go to different tasks. Trials are numbered by scenario, then by seed;
/// an unusable scenario has numbers, too, since it may be unusable on one machine alone.
struct TrialShare {
  std::size_t share = 1;  ///< 1 to `shares`
  std::size_t shares = 1;

  bool takes(std::size_t trial) const { return trial % shares + 1 == share; }
};

/// A folder that holds a file for each trial of scenarios, SCENARIO/seed-K.jsonl, written by any
/// number of tasks on any number of machines (`trial_file.h`).
struct TrialFolder {
  std::filesystem::path path;
  vo::Durability durability = vo::Durability::synced;
};

/// The share of a task, and where it keeps the trials.
struct TrialTask {
  TrialShare share;
  TrialFolder folder;
};

/// What has become of a share.
struct ShareOutcome {
  std::size_t trials = 0;              ///< number of the share's trials
  std::size_t kept = 0;                ///< of which there were already
  std::vector<std::string> unusable;   ///< a sentence for each trial or scenario that is unusable
  std::vector<std::string> temporary;  ///< a sentence for each trial to be run again
};

/// Runs the trials of a share, of scenarios in the order that numbers them, and writes each into
/// the folder when it has ended, unless its file is there with the same key. A trial with a
/// temporary problem is not written; an unusable one is, and run again by the next run of the
/// share, for its machine may lack something. Nothing is judged. Throws vo::Error of kind
/// output_exists, before anything is run, for a file with another key, unless the settings say to
/// measure again.
ShareOutcome run_share(const std::vector<LoadedScenario>& scenarios, const TrialTask& task,
                       const RunSettings& settings, const vo::Progress& progress,
                       const vo::WaitObserver& waiting, const TrialObserver& observe);

/// A trial without a file, or with a damaged one.
struct MissingTrial {
  std::size_t number = 0;  ///< from 0, as TrialShare counts
  std::string name;        ///< scenario, seed and what is wrong with its file
};

/// The trials of scenarios from a folder.
struct CollectedTrials {
  std::vector<TrialResult> trials;    ///< of the usable scenarios, in the order of their numbers
  std::vector<MissingTrial> missing;  ///< in order
  std::size_t expected = 0;           ///< number of all trials

  /// Returns the shares, of so many, that a missing trial belongs to, ascending.
  std::vector<std::size_t> missing_shares(std::size_t shares) const;

  /// Returns the names of the first missing trials, and how many more there are.
  std::string names_of_missing() const;
};

/// Reads the trials that tasks have left in a folder, as `run_trials` returns them where none is
/// missing. Throws vo::Error of kind output_exists, which names what differs, for a file with
/// another key.
CollectedTrials collect_trials(const std::vector<LoadedScenario>& scenarios,
                               const std::filesystem::path& folder, const RunSettings& settings,
                               const vo::Progress& progress);

}  // namespace tools
