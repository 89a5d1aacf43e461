#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/outside_tracker/problem_kind.h"
#include "tools/scenario/scenario.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {

/// Limits of an external tracker, with all processes that it starts, on one sequence.
struct TrackerLimits {
  double time_limit = 600;     ///< wall time, s
  double memory_limit = 4000;  ///< private resident memory of all its processes together, MB
  int process_limit = 256;     ///< number of processes at a time
  double output_limit = 100;   ///< what it prints, MB
  double file_limit = 1000;    ///< size of each file that it writes, MB

  void validate() const;  ///< throws vo::Error on an invalid option
};

template <typename Visitor>
void visit_fields(Visitor& visit, TrackerLimits& limits) {
  visit("time_limit", limits.time_limit, "per sequence, s");
  visit("memory_limit", limits.memory_limit, "of all its processes together, MB");
  visit("process_limit", limits.process_limit, "processes at a time");
  visit("output_limit", limits.output_limit, "of what it prints, MB");
  visit("file_limit", limits.file_limit, "of each file that it writes, MB");
}

/// An external tracking program: a command in which {sequence} stands for the folder of an RGB-D
/// sequence, {camera} for its camera.toml and {output} for the TUM trajectory to write
/// (`tracker_command.h`). Exit code 0 means success, 5 (as in `edvo track`) that poses of some or
/// all frames are missing because tracking was lost.
struct OutsideTracker {
  std::string command;
  TrackerLimits limits{};
  std::filesystem::path withheld{};  ///< folder that holds the truth, kept from the tracker

  void validate() const;  ///< throws vo::Error on an invalid option
};

/// A tracker's result on a sequence, or why there is none.
struct OutsideRun {
  vo::SequenceResult tracking;              ///< frames carry only their status and pose
  std::string problem;                      ///< one sentence; empty on success
  ProblemKind kind = ProblemKind::tracker;  ///< kind of the problem, if there is one
};

/// Runs the tracker on a copy of the sequence in `folder` without its truth (`staged_sequence.h`),
/// with depth where the content says so, and moves its poses so that the first one equals the
/// ground truth's. It is a problem when the program crashes, exceeds a limit, or writes no valid
/// trajectory of the sequence. Throws vo::Error when the copy cannot be made, and what `waiting`
/// throws.
OutsideRun track_outside(const OutsideTracker& tracker, const std::filesystem::path& folder,
                         vo::SequenceContent content, const vo::SequenceReader& sequence,
                         const vo::WaitObserver& waiting);

/// Returns the bounds without those on metrics that only edvo's own tracker reports: keyframes,
/// covariances, maps.
std::map<std::string, Bound> outside_bounds(const std::map<std::string, Bound>& expect);

}  // namespace tools
