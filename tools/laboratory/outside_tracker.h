#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/processes/file_lock.h"
#include "tools/scenario/scenario.h"
#include "vo/dataset/sequence.h"
#include "vo/odometry/track_sequence.h"

namespace tools {

/// A program that tracks: a command of the shell in which {sequence} stands for the folder of an
/// RGB-D sequence, {camera} for its camera.toml and {output} for the TUM trajectory to write. Exit
/// code 0 says that it is done, 5 (as of `edvo track`) that frames, or all, are missing because it
/// was lost.
struct OutsideTracker {
  std::string command;
  double time_limit = 600;  ///< s, for one sequence

  void validate() const;  ///< throws vo::Error
};

/// Runs it on the sequence in `folder`, whose poses are then moved so that the first one is the
/// truth's. Frames carry their status alone. Throws vo::Error, in a sentence, when the program
/// crashes, takes too long, or writes nothing or something else than a trajectory of the sequence.
vo::SequenceResult track_outside(const OutsideTracker& tracker, const std::filesystem::path& folder,
                                 const vo::SequenceReader& sequence, const WaitObserver& waiting);

/// The bounds of what is known of an outside program: not of keyframes and covariances.
std::map<std::string, Bound> outside_bounds(const std::map<std::string, Bound>& expect);

}  // namespace tools
