#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/live/event_feed.h"
#include "tools/watch/event_text.h"

namespace tools {

/// The files of a track that is done. Those whose path is empty are not there.
struct TrackFiles {
  std::filesystem::path trajectory;  ///< in any format that trajectories are read in
  std::filesystem::path frame_log;   ///< `vo::format_frame_log` or `format_mono_log`
  std::filesystem::path time_log;    ///< `vo::format_time_log`
  std::filesystem::path panels;      ///< folder of PNG files, `PanelWriter`
};

/// Adds the files that are not named and lie beside the trajectory: `e.csv`, `e_times.csv` and
/// `e_panels` of `e.txt`.
TrackFiles with_files_beside(TrackFiles files);

/// The panel of a frame.
struct FramePanel {
  std::size_t frame = 0;
  std::filesystem::path file;
};

/// A track that is done, as its page shows it.
struct FinishedTrack {
  std::string title;
  std::vector<WatchedFrame> frames;  ///< without a log those that have a pose
  std::vector<FramePanel> panels;    ///< in order

  std::size_t poses() const;  ///< number of frames that have one
};

/// Reads a track that is done. Throws vo::Error naming file and line where a log is none, or is of
/// another track.
FinishedTrack read_finished_track(const TrackFiles& files);

/// Tells a track as a run that is over, with pictures of at most a hundred frames, evenly spread.
/// Throws vo::Error naming a panel that is none.
void tell(const FinishedTrack& track, EventFeed& feed);

}  // namespace tools
