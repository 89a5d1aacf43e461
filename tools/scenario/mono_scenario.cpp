#include "tools/scenario/mono_scenario.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tools/depth/mono_run.h"

namespace tools {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMinPosesOfLength = 3;

/// Returns the length of the true path within the estimate's time span, m.
double tracked_length(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  vo::Trajectory covered;
  for (const vo::StampedPose& pose : truth) {
    if (pose.timestamp >= estimate.front().timestamp &&
        pose.timestamp <= estimate.back().timestamp) {
      covered.push_back(pose);
    }
  }
  return vo::path_length(covered);
}

bool has_metric_start(const OdometryOptions& odometry) {
  return odometry.mode == OdometryMode::mono && is_metric(odometry.mono.bootstrap);
}

void measure_trajectory(const Scenario& scenario, const vo::Trajectory& truth,
                        const TrackingRun& run, Metrics& metrics) {
  const vo::Trajectory& estimate = run.tracking.trajectory;
  if (!has_metric_start(scenario.odometry)) {
    metrics = without_own_judgement(metrics);
    metrics.drift_percent = kUnknown;
  }
  const double length = estimate.size() < kMinPosesOfLength ? 0 : tracked_length(truth, estimate);
  if (length == 0) {
    return;
  }
  metrics.ate_percent = 100 * metrics.ate_rmse_m / length;
  if (has_metric_start(scenario.odometry)) {
    const double scale =
        vo::evaluate(truth, estimate, {.alignment = vo::TrajectoryAlignment::sim3}).scale;
    metrics.scale_error_percent = 100 * std::abs(1 / scale - 1);
  }
  constexpr double kPer = 10;  // m of path that the drift refers to
  if (!run.maps.empty()) {
    metrics.scale_drift_percent =
        100 * std::abs(run.maps.back().errors.scale / run.maps.front().errors.scale - 1) * kPer /
        length;
  }
}

}  // namespace

TrackingRun track_mono_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                                const ScenarioObservers& observers, const vo::Progress& progress) {
  const vo::MonoOptions& options = scenario.odometry.mono;
  MapJudge judge(sequence, options.bootstrap);
  vo::FrameStream stream(sequence);
  bool is_first = true;
  const auto next = [&] {
    std::optional<vo::RgbdFrame> frame = stream.next();
    if (frame && !std::exchange(is_first, false)) {
      frame->depth.release();
    }
    return frame;
  };
  TrackingRun run;
  std::size_t index = 0;
  const vo::MonoObserver observe = [&](const vo::RgbdFrame& frame, const vo::MonoOdometry& odometry,
                                       const vo::MonoResult& result) {
    const std::size_t number = index++;
    if (observers.frame) {
      observers.frame(frame, odometry.current(), odometry.tracker(), result.tracking,
                      odometry.stage_times());
    }
    if (const std::optional<MappedFrame> mapped = judge.judge(odometry, result)) {
      run.maps.push_back(*mapped);
      if (observers.map) {
        observers.map(number, odometry.map(), judge.true_depth(), odometry.T_world_host());
      }
    }
  };
  run.tracking =
      vo::track_mono_images({.camera = sequence.camera().pinhole,
                             .T_world_first = sequence.ground_truth().front().T_world_camera,
                             .size = sequence.size(),
                             .next = next},
                            options, observe, progress)
          .tracking();
  return run;
}

TrackingRun map_scenario(const Scenario& scenario, const vo::SequenceReader& sequence,
                         const ScenarioObservers& observers, const vo::Progress& progress) {
  return {.tracking = {},
          .maps = map_sequence(sequence, scenario.odometry.mapping, observers.map, progress)};
}

void measure_map(const Scenario& scenario, const vo::Trajectory& truth, const TrackingRun& run,
                 Metrics& metrics) {
  if (scenario.odometry.mode == OdometryMode::mapping) {
    metrics.tracked_fraction = kUnknown;
    metrics.keyframes = kUnknown;
  } else {
    measure_trajectory(scenario, truth, run, metrics);
  }
  if (run.maps.empty()) {
    return;
  }
  const MapErrors& last = run.maps.back().errors;
  metrics.depth_error_percent = last.confident.median_percent;
  metrics.depth_outliers_percent = last.confident.outliers_percent;
  metrics.depth_nees = last.confident.nees;
  metrics.depth_density_fraction = last.density_percent / 100;
}

MapScale map_scale(const OdometryOptions& odometry) {
  return odometry.mode == OdometryMode::mono && !is_metric(odometry.mono.bootstrap)
             ? MapScale::arbitrary
             : MapScale::metric;
}

}  // namespace tools
