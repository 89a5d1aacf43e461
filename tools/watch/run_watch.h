#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "tools/live/event_feed.h"
#include "tools/live/latest_slot.h"
#include "tools/live/live_server.h"
#include "tools/live/pause_gate.h"
#include "tools/watch/event_text.h"
#include "tools/watch/frame_snapshot.h"
#include "vo/core/progress.h"
#include "vo/sequence_odometry/track_mono.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {

/// How a run is watched.
struct WatchOptions {
  int port = 0;  ///< of the page; 0 is any that is free
  bool is_paused =
      false;  ///< whether the run waits after its first frame until a viewer lets it go
};

/// Shows a run on a page while it runs. The figures of every frame are told; pictures of the latest
/// frame are drawn in a thread of low priority, and frames that come while it draws or rests are
/// left out, so that the run never waits, unless a viewer holds it up. Nothing that is told changes
/// what the run computes.
class RunWatch {
 public:
  /// Serves the page. `waiting` is called while a viewer holds the run up, and may throw to end it.
  /// Throws as LiveServer does.
  RunWatch(const WatchOptions& options, vo::WaitObserver waiting);
  ~RunWatch();
  RunWatch(const RunWatch&) = delete;
  RunWatch& operator=(const RunWatch&) = delete;
  RunWatch(RunWatch&&) = delete;
  RunWatch& operator=(RunWatch&&) = delete;

  const std::string& url() const { return server_.url(); }

  /// Begins a stage, whose frames count from 0.
  void begin(WatchedStage stage);

  /// Returns callbacks that show each frame after another callback was called with it, if there is
  /// one. They refer to this object.
  vo::FrameObserver observer(vo::FrameObserver other);
  vo::MonoObserver mono_observer(vo::MonoObserver other);

  /// Returns a callback that shows how many steps of a stage are done; it refers to this object.
  vo::Progress progress(vo::Progress other);

  /// Shows the frame of this index of a stage whose path is known.
  void show(std::size_t index, const RenderedFrame& frame);

  /// Takes the monocular map that belongs to the next frame that is shown.
  void show(const vo::DepthMap& map);

  /// Says that the run is over, and how it went.
  void finish(const std::string& how);

  /// Returns the number of frames of which no pictures were drawn
  std::size_t frames_without_pictures() const { return left_out_; }

 private:
  /// Pictures that are yet to be drawn.
  struct Drawing {
    std::size_t index = 0;  ///< of the frame
    std::function<FramePictures()> draw;
  };
  using TakeDrawing = std::function<Drawing()>;

  void show(const vo::TrackingResult& result, const vo::StageTimes& times,
            const std::function<FrameSnapshot()>& take);
  bool offer(const TakeDrawing& take);
  void draw_pictures();

  vo::WaitObserver waiting_;
  EventFeed feed_;
  PauseGate gate_;
  LiveServer server_;
  LatestSlot<Drawing> latest_;
  WatchedStage stage_;
  std::size_t frame_ = 0;  ///< number of frames of the stage that were shown
  std::size_t left_out_ = 0;
  std::optional<MapSnapshot> map_;  ///< that the next frame is shown with
  std::thread drawing_;
};

}  // namespace tools
