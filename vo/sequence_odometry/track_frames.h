#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "vo/core/progress.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace vo {

/// A source of RGB-D frames in order; `next` returns nothing after the last.
struct RgbdFrames {
  RgbdCamera camera;
  std::size_t size = 0;  ///< number of frames; 0 = not known
  std::function<std::optional<RgbdFrame>()> next;
};

/// Tracks frames as `track_sequence` does, from whatever gives them.
SequenceResult track_frames(const RgbdFrames& frames, const TrackerOptions& options,
                            const SE3& T_world_first, const FrameObserver& observe,
                            const Progress& progress);

}  // namespace vo
