#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "synth/sequence/render_sequence.h"
#include "tools/depth/mapping_run.h"
#include "tools/scenario/scenario.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/files/output.h"
#include "vo/odometry/track_sequence.h"

namespace tools {

struct BoundCheck {
  std::string metric;
  double measured = 0;
  Bound bound;
  bool holds = false;
};

struct Outcome {
  vo::SequenceResult tracking;    ///< empty in mode mapping
  std::vector<MappedFrame> maps;  ///< of modes mono and mapping
  vo::Trajectory truth;
  Metrics metrics;  ///< NaN where too little was tracked to measure
  std::vector<BoundCheck> checks;
  std::vector<std::string> notes;  ///< what the scene file holds that was left out

  bool passed() const;
};

/// What the scenario renders.
synth::RenderJob render_job(const Scenario& scenario);

/// NaN where too little was tracked to measure.
Metrics measure(const vo::Trajectory& truth, const vo::SequenceResult& tracking,
                const ScoreOptions& score);

/// The bounds of metrics that were measured, in the order of the metrics.
std::vector<BoundCheck> check_bounds(const Metrics& metrics,
                                     const std::map<std::string, Bound>& expect);

/// Told after each frame; empty ones are not called.
struct ScenarioObservers {
  vo::FrameObserver frame;  ///< of modes rgbd and mono
  MapObserver map;          ///< of modes mono and mapping
};

/// Tracks a sequence as the scenario says, from the true first pose, and evaluates.
Outcome track_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                       const ScenarioObservers& observers, const vo::Progress& progress);

/// Told of the two long steps' progress.
struct RunProgress {
  vo::Progress render;
  vo::Progress track;
};

/// Renders the scenario's sequence into `folder`/sequence (unless it is there) and tracks it.
Outcome run_scenario(const Scenario& scenario, const std::filesystem::path& folder,
                     vo::ExistingOutput existing, const ScenarioObservers& observers,
                     const RunProgress& progress);

}  // namespace tools
