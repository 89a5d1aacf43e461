#pragma once

#include <vector>

#include "tools/depth/depth_output.h"
#include "tools/scenario/run_scenario.h"

namespace tools {

/// What tracking or mapping a scenario gave.
struct TrackingRun {
  vo::SequenceResult tracking;
  std::vector<MappedFrame> maps;
};

/// Mode mono: colour alone, but for the first frame's depth where the bootstrap asks for it.
TrackingRun track_mono_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                                const ScenarioObservers& observers, const vo::Progress& progress);

/// Mode mapping: the poses are true, nothing is tracked.
TrackingRun map_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                         const ScenarioObservers& observers, const vo::Progress& progress);

/// Whether the maps of a scenario's mode are in metres or of unknown scale.
MapScale map_scale(const OdometryOptions& odometry);

/// Fills in what the last map and the trajectory's scale say.
void measure_map(const Scenario& scenario, const vo::Trajectory& truth, const TrackingRun& run,
                 Metrics& metrics);

}  // namespace tools
