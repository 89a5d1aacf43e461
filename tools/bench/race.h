#pragma once

#include <string>
#include <vector>

#include "tools/bench/frames.h"
#include "tools/bench/peer.h"
#include "vo/core/progress.h"
#include "vo/geometry/trajectory.h"

namespace tools {

struct RaceOptions {
  int warm_up = 5;  ///< frames at the start that are tracked and not counted
  int repeats = 3;  ///< of the whole sequence; a frame's time is the median over them

  void validate() const;  ///< throws vo::Error
};

/// All samples of one peer.
struct RaceResult {
  std::string name;
  std::vector<std::vector<FrameSample>> samples;  ///< [repeat][frame], with those of the warm-up
};

/// Every peer tracks every frame, one thread, blocks of frames in turn, so that a machine
/// that is slow for a while is slow for all. Contestants do not see each other's state.
std::vector<RaceResult> race(const Frames& input, const std::vector<Peer>& peers,
                             const RaceOptions& options, const vo::Progress& progress);

/// The trajectory that the peer found.
vo::Trajectory trajectory(const RaceResult& result, const Frames& input);

}  // namespace tools
