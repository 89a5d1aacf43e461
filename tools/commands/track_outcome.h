#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/cli/session.h"
#include "tools/commands/track_arguments.h"
#include "tools/point_cloud/keyframe_cloud.h"
#include "vo/core/fields.h"
#include "vo/sequence_odometry/track_mono.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {

/// A camera that ran while its frames were tracked.
struct TrackedCamera {
  std::string device;
  std::size_t dropped = 0;  ///< frames that came while others were tracked
};

/// A sequence, or what a camera saw, that was tracked in either mode.
struct Tracked {
  vo::SequenceResult result;
  std::vector<vo::Field> options;
  std::string log;                               ///< CSV with a line per frame
  const vo::MonoSequenceResult* mono = nullptr;  ///< result of mode mono
  std::string note;                              ///< what a user of the trajectory must know
  std::vector<std::string> sequence_notes;       ///< what in the sequence's files was mended
  std::optional<TrackedCamera> camera;           ///< empty for a sequence

  bool is_complete() const {
    return result.tracked_fraction() == 1 && result.uncertain() == 0 &&
           (mono == nullptr || mono->oriented_poses + mono->scale_uncertain_poses == 0);
  }

  /// Returns how it went, in a few words.
  std::string text() const;
};

/// Writes the trajectory, the options and, where they are asked for, log and map.
void write_tracked(const TrackArguments& arguments, const Tracked& tracked, KeyframeCloud& cloud);

/// Prints the result, its note last, and returns the exit code.
int print_tracked(const TrackArguments& arguments, const Tracked& tracked, const Session& session);

}  // namespace tools
