#include "tools/watch/run_watch.h"

#include <chrono>
#include <ctime>
#include <memory>
#include <utility>

#include <sys/resource.h>

#include "tools/report/pictures_json.h"
#include "tools/watch/event_text.h"
#include "tools/watch/watch_page.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Returns how long this thread has had a processor.
std::chrono::nanoseconds processor_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

RunWatch::RunWatch(const WatchOptions& options, vo::WaitObserver waiting)
    : waiting_(std::move(waiting)),
      server_({.page = watch_page(), .feed = &feed_, .gate = &gate_}, {options.port}),
      drawing_([this] { draw_pictures(); }) {
  if (options.is_paused) {
    gate_.pause();
    feed_.replace("gate", R"({"paused":true})");
  }
}

RunWatch::~RunWatch() {
  latest_.close();
  drawing_.join();
}

void RunWatch::begin(WatchedStage stage) {
  stage_ = std::move(stage);
  frame_ = 0;
  feed_.keep("stage", stage_text(stage_));
  if (!stage_.path.empty()) {
    feed_.keep("path", path_text(stage_.path));
  }
}

vo::FrameObserver RunWatch::observer(vo::FrameObserver other) {
  return
      [this, other = std::move(other)](const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                                       const vo::Tracker& tracker, const vo::TrackingResult& result,
                                       const vo::StageTimes& times) {
        if (other) {
          other(frame, pyramid, tracker, result, times);
        }
        show(result, times, [&] { return snapshot_of(frame, pyramid, tracker, result); });
      };
}

vo::MonoObserver RunWatch::mono_observer(vo::MonoObserver other) {
  return
      [this, other = std::move(other)](const vo::RgbdFrame& frame, const vo::MonoOdometry& odometry,
                                       const vo::MonoResult& result) {
        if (other) {
          other(frame, odometry, result);
        }
        show(result.tracking, odometry.stage_times(), [&] {
          FrameSnapshot snapshot =
              snapshot_of(frame, odometry.current(), odometry.tracker(), result.tracking);
          snapshot.map = snapshot_of(odometry.map());
          return snapshot;
        });
      };
}

void RunWatch::show(const vo::TrackingResult& result, const vo::StageTimes& times,
                    const std::function<FrameSnapshot()>& take) {
  const std::size_t index = frame_++;
  feed_.keep("frame", frame_text({.index = index,
                                  .result = result,
                                  .times = times,
                                  .T_world_true = vo::pose_at(stage_.truth, result.timestamp)}));
  const TakeDrawing take_drawing = [&]() -> Drawing {
    auto snapshot = std::make_shared<FrameSnapshot>(take());
    if (map_) {
      snapshot->map = std::exchange(map_, std::nullopt);
    }
    return {index, [snapshot] { return draw(*snapshot); }};
  };
  bool has_pictures = offer(take_drawing);
  gate_.pass([&] {
    has_pictures = has_pictures || offer(take_drawing);
    if (waiting_) {
      waiting_();
    }
  });
  left_out_ += has_pictures ? 0 : 1;
}

void RunWatch::show(std::size_t index, const RenderedFrame& frame) {
  const bool has_pictures = offer([&]() -> Drawing {
    return {index, [frame] { return draw(frame); }};
  });
  left_out_ += has_pictures ? 0 : 1;
}

void RunWatch::show(const vo::DepthMap& map) {
  if (feed_.viewers() > 0 && (gate_.is_paused() || latest_.is_wanted())) {
    map_ = snapshot_of(map);
  }
}

vo::Progress RunWatch::progress(vo::Progress other) {
  return [this, other = std::move(other)](std::size_t done, std::size_t total) {
    if (other) {
      other(done, total);
    }
    if (total > 0) {
      feed_.replace("progress", progress_text(done, total));
      gate_.pass(waiting_);
    }
  };
}

/// Gives a drawing to the thread that draws if there is somebody to see it and that thread has
/// time for it; a viewer who steps from frame to frame gets the pictures of each. Returns whether
/// it was given.
bool RunWatch::offer(const TakeDrawing& take) {
  if (feed_.viewers() == 0) {
    return false;
  }
  if (gate_.is_paused()) {
    latest_.wait_until_wanted(waiting_);
  } else if (!latest_.is_wanted()) {
    return false;
  }
  latest_.put(take());
  return true;
}

/// Draws what is offered, and rests after each for several times as long as it has drawn, so that
/// it leaves the processor to the run.
void RunWatch::draw_pictures() {
  constexpr int kLowPriority = 10;
  constexpr int kRest = 3;  // per time of drawing
  ::setpriority(PRIO_PROCESS, 0, kLowPriority);
  while (const std::optional<Drawing> drawing = latest_.take()) {
    const std::chrono::nanoseconds begin = processor_time();
    try {
      feed_.replace("pictures", event_text(pictures_json(drawing->draw(), drawing->index)));
    } catch (const vo::Error& error) {
      feed_.replace("problem", problem_text(error.what()));
    }
    if (!gate_.is_paused()) {
      latest_.rest(std::chrono::duration_cast<std::chrono::milliseconds>(
          kRest * (processor_time() - begin)));
    }
  }
}

void RunWatch::finish(const std::string& how) {
  feed_.end("end", end_text(how, left_out_));
}

}  // namespace tools
