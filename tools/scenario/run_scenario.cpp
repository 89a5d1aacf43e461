#include "tools/scenario/run_scenario.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tools/scenario/consistency.h"
#include "tools/scenario/mono_scenario.h"
#include "vo/dataset/sequence.h"

namespace tools {
namespace {

/// Returns the estimate's final position error over the length of the true path, %.
double drift_percent(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  const auto T_world_true = vo::pose_at(truth, estimate.back().timestamp);
  const double length = vo::path_length(truth);
  if (!T_world_true || length == 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const Eigen::Vector3d error =
      estimate.back().T_world_camera.translation() - T_world_true->translation();
  return 100 * error.norm() / length;
}

/// Returns the greatest distance between two runs' positions, m; infinite if the numbers of poses
/// differ.
double greatest_difference(const vo::SequenceResult& a, const vo::SequenceResult& b) {
  if (a.trajectory.size() != b.trajectory.size()) {
    return std::numeric_limits<double>::infinity();
  }
  double greatest = 0;
  for (std::size_t i = 0; i < a.trajectory.size(); ++i) {
    greatest = std::max(greatest, (a.trajectory[i].T_world_camera.translation() -
                                   b.trajectory[i].T_world_camera.translation())
                                      .norm());
  }
  return greatest;
}

TrackingRun track_once(const Scenario& scenario, const vo::SequenceReader& sequence,
                       const ScenarioObservers& observers, const vo::Progress& progress) {
  switch (scenario.odometry.mode) {
    case OdometryMode::mono:
      return track_mono_scenario(scenario, sequence, observers, progress);
    case OdometryMode::mapping:
      return map_scenario(scenario, sequence, observers, progress);
    case OdometryMode::rgbd:
      break;
  }
  const vo::SE3 T_world_first = sequence.ground_truth().front().T_world_camera;
  return {.tracking = vo::track_sequence(sequence, scenario.odometry.tracker, T_world_first,
                                         observers.frame, progress),
          .maps = {}};
}

}  // namespace

bool Outcome::passed() const {
  return std::all_of(checks.begin(), checks.end(), [](const BoundCheck& c) { return c.holds; });
}

Metrics measure(const vo::Trajectory& truth, const vo::SequenceResult& tracking,
                const ScoreOptions& score) {
  constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t kMinPoses = 3;
  Metrics metrics = make_metrics([](const std::string&) { return kNotMeasured; });
  metrics.tracked_fraction = tracking.tracked_fraction();
  metrics.keyframes = static_cast<double>(tracking.keyframes());
  const Nees relative = relative_nees(truth, tracking.frames);
  metrics.nees_median = relative.median;
  metrics.nees_p90 = relative.p90;
  const Nees absolute = absolute_nees(truth, tracking.frames);
  metrics.nees_absolute_median = absolute.median;
  metrics.nees_absolute_p90 = absolute.p90;
  metrics.sure_error_max_m = greatest_sure_error(truth, tracking.frames);
  if (tracking.trajectory.size() >= kMinPoses) {
    const vo::TrajectoryErrors errors =
        vo::evaluate(truth, tracking.trajectory,
                     {.alignment = score.align, .interval = {.length = score.interval}});
    metrics.ate_rmse_m = errors.ate.rmse;
    metrics.ate_max_m = errors.ate.max;
    metrics.rpe_translation_rmse_m = errors.rpe.translation.rmse;
    metrics.rpe_rotation_rmse_deg = errors.rpe.rotation_deg.rmse;
    metrics.drift_percent = drift_percent(truth, tracking.trajectory);
  }
  return metrics;
}

std::vector<BoundCheck> check_bounds(const Metrics& metrics,
                                     const std::map<std::string, Bound>& expect) {
  std::vector<BoundCheck> checks;
  for (const auto& [metric, measured] : metric_values(metrics)) {
    const auto bound = expect.find(metric);
    if (bound != expect.end()) {
      checks.push_back({metric, measured, bound->second, bound->second.contains(measured)});
    }
  }
  return checks;
}

synth::RenderJob render_job(const Scenario& scenario) {
  synth::GltfOptions parts = scenario.resolved_parts();
  parts.needed = synth::needed_textures({.render = scenario.render, .channels = scenario.truth()});
  return render_job(scenario, synth::SceneFile(scenario.scene_file(), parts, scenario.actors));
}

synth::RenderJob render_job(const Scenario& scenario, const synth::SceneFile& scene) {
  synth::RenderJob job;
  job.recipe.camera = scenario.camera.camera();
  job.recipe.render = scenario.render;
  job.recipe.sensor = scenario.sensor;
  job.recipe.channels = scenario.truth();
  job.scene = scene;
  synth::TimedPath timed = synth::make_path(scenario.resolved_path(), job.scene);
  job.recipe.truth = synth::sample(timed.path, timed.times);
  job.recipe.path = std::move(timed.path);
  return job;
}

Outcome track_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                       const ScenarioObservers& observers, const vo::Progress& progress) {
  Outcome outcome;
  outcome.truth = sequence.ground_truth();
  const auto track = [&](const ScenarioObservers& told) {
    return track_once(scenario, sequence, told, progress);
  };
  TrackingRun first = track(observers);
  outcome.metrics = measure(outcome.truth, first.tracking, scenario.score);
  if (scenario.odometry.mode != OdometryMode::rgbd) {
    measure_map(scenario, outcome.truth, first, outcome.metrics);
  }
  outcome.tracking = std::move(first.tracking);
  outcome.maps = std::move(first.maps);
  if (scenario.expect.contains("repeat_difference_m")) {
    outcome.metrics.repeat_difference_m = greatest_difference(outcome.tracking, track({}).tracking);
  }
  outcome.checks = check_bounds(outcome.metrics, scenario.expect);
  return outcome;
}

Outcome run_scenario(const Scenario& scenario, const std::filesystem::path& folder,
                     const vo::OutputPolicy& policy, const ScenarioObservers& observers,
                     const RunProgress& progress) {
  const synth::RenderJob job = render_job(scenario);
  if (progress.before_rendering) {
    progress.before_rendering(job.recipe);
  }
  synth::RenderOutcome rendered =
      synth::render_sequence(job, folder / "sequence", policy, progress.render, progress.rendered);
  const vo::SequenceReader sequence(folder / "sequence");
  if (progress.before_tracking) {
    progress.before_tracking(sequence);
  }
  Outcome outcome = track_scenario(scenario, sequence, observers, progress.track);
  outcome.notes = std::move(rendered.notes);
  return outcome;
}

}  // namespace tools
