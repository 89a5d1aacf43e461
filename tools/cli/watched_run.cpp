#include "tools/cli/watched_run.h"

#include <chrono>
#include <iostream>
#include <thread>
#include <utility>

#include "tools/cli/interrupt.h"
#include "tools/watch/event_text.h"
#include "vo/core/error.h"

namespace tools {
namespace {

void say_where(const std::string& url) {
  std::cerr << "live at " << url << "\n";
}

void keep_until_interrupt(const std::string& url) {
  std::cerr << "the run is over; Ctrl-C closes " << url << "\n";
  wait_for_interrupt();
}

}  // namespace

WatchedRun::WatchedRun(const LiveArguments& arguments) : is_kept_(arguments.keep) {
  if (arguments.is_asked()) {
    watch_ = std::make_unique<RunWatch>(
        WatchOptions{.port = arguments.chosen_port(), .is_paused = arguments.paused},
        throw_if_interrupted);
    say_where(watch_->url());
  }
}

void WatchedRun::begin(WatchedStage stage) {
  if (watch_) {
    watch_->begin(std::move(stage));
  }
}

vo::FrameObserver WatchedRun::observer(vo::FrameObserver other) {
  return watch_ ? watch_->observer(std::move(other)) : other;
}

vo::MonoObserver WatchedRun::mono_observer(vo::MonoObserver other) {
  return watch_ ? watch_->mono_observer(std::move(other)) : other;
}

vo::Progress WatchedRun::progress(vo::Progress other) {
  return watch_ ? watch_->progress(std::move(other)) : other;
}

void WatchedRun::finish(const std::string& how) {
  if (watch_) {
    watch_->finish(how);
    if (is_kept_) {
      keep_until_interrupt(watch_->url());
    }
    watch_.reset();
  }
}

WatchedTrials::WatchedTrials(const LiveArguments& arguments, const std::string& title,
                             std::size_t trials)
    : is_kept_(arguments.keep) {
  if (arguments.is_asked()) {
    page_ = std::make_unique<PageProcess>(arguments.chosen_port());
    say_where(page_->url());
    page_->keep("stage", stage_text({.name = "testing", .title = title, .frames = trials}));
  }
}

vo::Progress WatchedTrials::progress(vo::Progress other) {
  return !page_ ? other : [this, other = std::move(other)](std::size_t done, std::size_t total) {
    other(done, total);
    page_->replace("progress", progress_text(done, total));
  };
}

void WatchedTrials::tell(const std::string& name, const std::string& verdict,
                         const std::string& text) {
  if (page_) {
    page_->keep("trial", trial_text(name, verdict, text));
  }
}

void WatchedTrials::finish(const std::string& how) {
  if (page_) {
    page_->keep("end", end_text(how, 0));
    if (is_kept_) {
      keep_until_interrupt(page_->url());
    }
    page_.reset();
  }
}

WatchedStage rendering_stage(const synth::SequenceRecipe& recipe, const std::string& title) {
  const vo::PinholeCamera* const pinhole = recipe.camera.model.pinhole();
  return {.name = "rendering",
          .title = title,
          .frames = recipe.truth.size(),
          .camera = pinhole == nullptr ? std::nullopt : std::optional(*pinhole),
          .truth = {},
          .path = recipe.truth};
}

synth::MadeFrameObserver rendered_frames_on(WatchedRun& run, double depth_units_per_m) {
  if (run.page() == nullptr) {
    return {};
  }
  return
      [&page = *run.page(), depth_units_per_m](std::size_t index, const synth::MadeFrame& frame) {
        page.show(index, {.image = frame.files.at(0).bytes,
                          .depth = frame.files.at(1).bytes,
                          .depth_units_per_m = depth_units_per_m});
      };
}

WatchedStage tracking_stage(const vo::SequenceReader& sequence, const std::string& title,
                            const vo::Trajectory& truth) {
  return {.name = "tracking",
          .title = title,
          .frames = sequence.size(),
          .camera = sequence.camera().pinhole,
          .truth = truth,
          .path = {}};
}

void wait_for_interrupt() {
  constexpr std::chrono::milliseconds kPeriod(50);
  try {
    for (;;) {
      throw_if_interrupted();
      std::this_thread::sleep_for(kPeriod);
    }
  } catch (const vo::Error& error) {
    if (error.kind() != vo::ErrorKind::interrupted) {
      throw;
    }
  }
}

}  // namespace tools
