#pragma once

#include <string>
#include <vector>

#include "tools/bench/frames.h"
#include "tools/bench/peer.h"
#include "vo/core/progress.h"
#include "vo/geometry/trajectory.h"

namespace tools {

struct RaceOptions {
  int warm_up = 5;  ///< frames at the start that are tracked but not counted
  int repeats = 3;  ///< runs of the whole sequence; a frame's time is their median

  void validate() const;  ///< throws vo::Error on an invalid option
};

/// All samples of one peer.
struct RaceResult {
  std::string name;
  std::vector<std::vector<FrameSample>> samples;  ///< [repeat][frame], including the warm-up
};

/// Lets every peer track every frame on one thread, blocks of frames in turn, so that a slow phase
/// of the machine affects all. Peers do not share state.
std::vector<RaceResult> race(const Frames& input, const std::vector<Peer>& peers,
                             const RaceOptions& options, const vo::Progress& progress);

/// Returns the trajectory that the peer estimated in the first repeat.
vo::Trajectory trajectory(const RaceResult& result, const Frames& input);

}  // namespace tools
