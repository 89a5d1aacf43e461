#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/laboratory/results.h"
#include "tools/processes/file_lock.h"
#include "tools/scenario/scenario.h"
#include "vo/dataset/sequence.h"
#include "vo/odometry/track_sequence.h"

namespace tools {

/// An external tracking program: a shell command in which {sequence} stands for the folder of an
/// RGB-D sequence, {camera} for its camera.toml and {output} for the TUM trajectory to write. Exit
/// code 0 means success, 5 (as in `edvo track`) that poses of some or all frames are missing
/// because tracking was lost.
struct OutsideTracker {
  std::string command;
  double time_limit = 600;  ///< time limit for one sequence, s

  void validate() const;  ///< throws vo::Error on an invalid option
};

/// A tracker's result on a sequence, or why there is none.
struct OutsideRun {
  vo::SequenceResult tracking;  ///< frames carry only their status and pose
  std::string problem;          ///< one sentence; empty on success
  ProblemKind kind = ProblemKind::tracker;
};

/// Runs the tracker on the sequence in `folder` and moves its poses so that the first one equals
/// the ground truth's. It is a problem when the program crashes, takes too long, or writes no valid
/// trajectory of the sequence. Only exceptions thrown by `waiting` propagate.
OutsideRun track_outside(const OutsideTracker& tracker, const std::filesystem::path& folder,
                         const vo::SequenceReader& sequence, const WaitObserver& waiting);

/// Returns the bounds without those on metrics that only edvo's own tracker reports: keyframes,
/// covariances, maps.
std::map<std::string, Bound> outside_bounds(const std::map<std::string, Bound>& expect);

}  // namespace tools
