#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "synth/sequence/render_sequence.h"
#include "tools/depth/mapping_run.h"
#include "tools/scenario/scenario.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/files/output.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {

struct BoundCheck {
  std::string metric;
  double measured = 0;
  Bound bound;
  bool holds = false;
};

struct Outcome {
  vo::SequenceResult tracking;    ///< tracked frames and poses; empty in mode mapping
  std::vector<MappedFrame> maps;  ///< maps after each frame in modes mono and mapping
  vo::Trajectory truth;
  Metrics metrics;  ///< metrics; NaN where too little was tracked to measure
  std::vector<BoundCheck> checks;
  std::vector<std::string> notes;  ///< parts of the scene file that were ignored

  bool passed() const;
};

/// Returns the render job of the scenario. Throws vo::Error when the scene or path is unusable.
synth::RenderJob render_job(const Scenario& scenario);

/// Returns the render job of the scenario in a scene that is open already.
synth::RenderJob render_job(const Scenario& scenario, const synth::SceneFile& scene);

/// Evaluates a tracked sequence; metrics are NaN where too little was tracked to measure.
Metrics measure(const vo::Trajectory& truth, const vo::SequenceResult& tracking,
                const ScoreOptions& score);

/// Checks the metrics against their bounds, in the order of the metrics; NaN violates a bound.
std::vector<BoundCheck> check_bounds(const Metrics& metrics,
                                     const std::map<std::string, Bound>& expect);

/// Callbacks after each frame; empty ones are not called.
struct ScenarioObservers {
  vo::FrameObserver frame;  ///< called in modes rgbd and mono
  MapObserver map;          ///< called in modes mono and mapping
};

/// Tracks a sequence with the scenario's options, from the true first pose, and evaluates it.
Outcome track_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                       const ScenarioObservers& observers, const vo::Progress& progress);

/// What is told of rendering a sequence, and then of tracking or reading it; an empty callback is
/// not called, but for those of progress.
struct RunProgress {
  vo::Progress render;
  vo::Progress track;
  std::function<void(const synth::SequenceRecipe&)> before_rendering;
  synth::MadeFrameObserver rendered;
  std::function<void(const vo::SequenceReader&)> before_tracking;
};

/// Renders the scenario's sequence into `folder`/sequence (unless it is there) and tracks it.
Outcome run_scenario(const Scenario& scenario, const std::filesystem::path& folder,
                     const vo::OutputPolicy& policy, const ScenarioObservers& observers,
                     const RunProgress& progress);

}  // namespace tools
