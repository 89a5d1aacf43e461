#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "synth/sequence/generate.h"
#include "tools/cli/live_arguments.h"
#include "tools/watch/page_process.h"
#include "tools/watch/run_watch.h"
#include "vo/dataset/sequence.h"
#include "vo/sequence_odometry/track_mono.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {

/// A command's run, which is shown on a page where the user asked for it; else nothing is done.
class WatchedRun {
 public:
  /// Serves the page and says on stderr where it is. Throws as RunWatch does.
  explicit WatchedRun(const LiveArguments& arguments);

  void begin(WatchedStage stage);

  /// Returns callbacks that show each frame after the other callback; they refer to this object.
  vo::FrameObserver observer(vo::FrameObserver other);
  vo::MonoObserver mono_observer(vo::MonoObserver other);

  vo::Progress progress(vo::Progress other);

  /// The page, to show on it what has no callback; null where nobody asked for one.
  RunWatch* page() const { return watch_.get(); }

  /// Says on the page how the run went, after all results were written. Where the page is kept it
  /// returns when the user interrupts the program, which then ends as if there were no page.
  void finish(const std::string& how);

 private:
  bool is_kept_;
  std::unique_ptr<RunWatch> watch_;
};

/// Many runs, whose results are shown on a page where the user asked for it; else nothing is done.
class WatchedTrials {
 public:
  /// Serves the page, from a process of its own, and says on stderr where it is. Throws as
  /// PageProcess does.
  WatchedTrials(const LiveArguments& arguments, const std::string& title, std::size_t trials);

  vo::Progress progress(vo::Progress other);  ///< refers to this object

  /// Says how a trial has ended: its verdict in a word, and its figures or its problem.
  void tell(const std::string& name, const std::string& verdict, const std::string& text);

  void finish(const std::string& how);  ///< as WatchedRun's

 private:
  bool is_kept_;
  std::unique_ptr<PageProcess> page_;
};

/// Returns the stage that renders a recipe's frames.
WatchedStage rendering_stage(const synth::SequenceRecipe& recipe, const std::string& title);

/// Returns a callback that shows rendered frames; an empty one where nobody asked for a page. It
/// refers to the run.
synth::MadeFrameObserver rendered_frames_on(WatchedRun& run, double depth_units_per_m);

/// Returns the stage that tracks a sequence. `truth` is as WatchedStage has it.
WatchedStage tracking_stage(const vo::SequenceReader& sequence, const std::string& title,
                            const vo::Trajectory& truth);

/// Returns when the user interrupts the program. Throws vo::Error where it is terminated.
void wait_for_interrupt();

}  // namespace tools
