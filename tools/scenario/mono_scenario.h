#pragma once

#include <vector>

#include "tools/depth/depth_output.h"
#include "tools/scenario/run_scenario.h"

namespace tools {

/// The results of tracking or mapping a scenario.
struct TrackingRun {
  vo::SequenceResult tracking;
  std::vector<MappedFrame> maps;
};

/// Runs mode mono, which gets only colour images and the first frame's depth image.
TrackingRun track_mono_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                                const ScenarioObservers& observers, const vo::Progress& progress);

/// Runs mode mapping, which takes the true poses and does not track.
TrackingRun map_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                         const ScenarioObservers& observers, const vo::Progress& progress);

/// Returns whether the maps are metric or of arbitrary scale.
MapScale map_scale(const OdometryOptions& odometry);

/// Fills in the metrics of the last map and of the trajectory's scale.
void measure_map(const Scenario& scenario, const vo::Trajectory& truth, const TrackingRun& run,
                 Metrics& metrics);

}  // namespace tools
