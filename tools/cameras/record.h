#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "tools/cameras/live_camera.h"
#include "vo/files/output.h"

namespace tools {

/// A RecordJob says where the frames of a running camera go, and how many.
struct RecordJob {
  std::filesystem::path out;  ///< folder in the layout of vo/dataset/sequence.h, without truth
  std::size_t frames = 0;     ///< most frames; 0 = until it is stopped
};

struct RecordOutcome {
  std::size_t frames = 0;
  std::size_t missed = 0;  ///< frames of the device that nobody took in time
  double duration_s = 0;   ///< from the first stamp to the last
};

/// A RecordObserver is asked whether to stop, and told of each frame.
struct RecordObserver {
  std::function<bool()> is_stopped;
  std::function<void(std::size_t frames)> on_frame;
};

/// Writes what a camera sees to a folder that appears under its name when the recording has ended,
/// by itself, by its number of frames or because it was stopped. Frames are encoded and written by
/// a second thread, at most 300 of them late. Throws Error where nothing was recorded.
RecordOutcome record(const LiveCamera& camera, const RecordJob& job, const vo::OutputPolicy& policy,
                     const RecordObserver& observer);

}  // namespace tools
