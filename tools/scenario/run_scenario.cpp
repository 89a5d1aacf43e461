#include "tools/scenario/run_scenario.h"

#include <algorithm>
#include <limits>

#include "tools/scenario/consistency.h"
#include "vo/io/sequence.h"

namespace tools {
namespace {

/// Distance of the estimate's last position from the truth at that time, over the truth's length.
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

Metrics measure(const vo::Trajectory& truth, const SequenceResult& tracking,
                const ScoreOptions& score) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t kMinPoses = 3;
  Metrics metrics{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  metrics.tracked_fraction = tracking.tracked_fraction();
  metrics.keyframes = static_cast<double>(tracking.keyframes());
  metrics.nees_median = nees_median(truth, tracking.frames);
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

}  // namespace

bool Outcome::passed() const {
  return std::all_of(checks.begin(), checks.end(), [](const BoundCheck& c) { return c.holds; });
}

RenderJob render_job(const Scenario& scenario) {
  const TimedPath timed = make_path(scenario.resolved_path(), scenario.scene_file());
  return {.scene = scenario.scene_file(),
          .recipe = {.truth = synth::sample(timed.path, timed.times),
                     .path = timed.path,
                     .camera = scenario.camera.camera(),
                     .render = scenario.render,
                     .sensor = scenario.sensor}};
}

Outcome run_scenario(const Scenario& scenario, const std::filesystem::path& folder,
                     vo::ExistingOutput existing, const FrameObserver& observe,
                     const RunProgress& progress) {
  Outcome outcome;
  outcome.notes =
      render_sequence(render_job(scenario), folder / "sequence", existing, progress.render).notes;

  const vo::SequenceReader sequence(folder / "sequence");
  outcome.truth = sequence.ground_truth();
  outcome.tracking = track_sequence(sequence, scenario.odometry.tracker,
                                    outcome.truth.front().T_world_camera, observe, progress.track);
  outcome.metrics = measure(outcome.truth, outcome.tracking, scenario.score);
  outcome.checks = check_bounds(outcome.metrics, scenario.expect);
  return outcome;
}

}  // namespace tools
