#include "synth/path_planning/path_options.h"

#include <optional>

#include "synth/path_planning/moving_obstacles.h"
#include "synth/ray_tracing/surface_tracer.h"
#include "synth/rendering/renderer.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/motion_files/trajectory_file.h"

namespace synth {
namespace {

vo::Trajectory control_poses(const PathOptions& options) {
  vo::Trajectory poses;
  const double step = options.duration / static_cast<double>(options.eyes.size() - 1);
  for (std::size_t i = 0; i < options.eyes.size(); ++i) {
    poses.push_back({static_cast<double>(i) * step,
                     vo::look_at(options.eyes[i], options.targets[i], Eigen::Vector3d::UnitY())});
  }
  return poses;
}

std::optional<vo::TrajectoryFormat> chosen_format(const PathOptions& options) {
  if (options.file_format.empty()) {
    return std::nullopt;
  }
  try {
    return vo::parse_enum<vo::TrajectoryFormat>(options.file_format);
  } catch (const vo::Error& error) {
    vo::fail("path.file_format: ", error.what());
  }
}

vo::Trajectory poses_of_file(const PathOptions& options) {
  const vo::TrajectoryReading reading{.format = chosen_format(options),
                                      .times = options.file_times};
  return vo::read_trajectory_file(options.file, reading).trajectory;
}

/// Returns the spline through a file's poses, sampled at `rate`, Hz, over their own time span.
TimedPath resampled(const vo::Trajectory& poses, double rate) {
  vo::require(poses.size() >= 2, "path.file: expected at least two poses for a spline");
  const double start = poses.front().timestamp;
  vo::Trajectory from_zero = poses;
  for (vo::StampedPose& pose : from_zero) {
    pose.timestamp -= start;
  }
  TimedPath result;
  result.times = sample_times(rate, from_zero.back().timestamp);
  for (double& time : result.times) {
    time += start;
  }
  result.path = [start, path = spline(from_zero)](double time) { return path(time - start); };
  return result;
}

/// Returns the poses at their own times, with a spline between them.
TimedPath as_recorded(const vo::Trajectory& poses) {
  TimedPath result;
  for (const vo::StampedPose& pose : poses) {
    result.times.push_back(pose.timestamp);
  }
  if (poses.size() == 1) {
    result.path = [T_world_camera = poses.front().T_world_camera](double) {
      return T_world_camera;
    };
  } else {
    result.path = spline(poses);
  }
  return result;
}

TimedPath explored(const PathOptions& options, const SceneFile& file) {
  const Scene scene = with_traces(file.scene(), options.duration);
  const SurfaceTracer tracer(scene, RenderOptions{}.ambient);
  const ExploredPath found = explore(tracer, options.duration, options.explore);
  const double duration = options.explore.length > 0 ? found.duration : options.duration;
  return {found.path, sample_times(options.rate, duration)};
}

TimedPath steady_path(const PathOptions& options, const SceneFile& scene) {
  const auto timed = [&](CameraPath path) {
    return TimedPath{std::move(path), sample_times(options.rate, options.duration)};
  };
  switch (options.kind) {
    case PathKind::orbit:
      return timed(orbit(options.orbit));
    case PathKind::spline:
      return options.file.empty() ? timed(spline(control_poses(options)))
                                  : resampled(poses_of_file(options), options.rate);
    case PathKind::trajectory:
      return as_recorded(poses_of_file(options));
    case PathKind::recorded:
      return resampled(placed(poses_of_file(options), options.recorded), options.rate);
    case PathKind::still:
      return timed(still(options.move));
    case PathKind::dolly:
      return timed(dolly(options.move, options.duration));
    case PathKind::pan:
      return timed(pan(options.move, options.duration));
    case PathKind::roll:
      return timed(roll(options.move, options.duration));
    case PathKind::explore:
      return explored(options, scene);
  }
  return {};
}

void require_file(const PathOptions& options) {
  vo::require(!options.file.empty(), "path.file: expected a trajectory file");
}

void validate_kind(const PathOptions& options) {
  switch (options.kind) {
    case PathKind::orbit:
      return options.orbit.validate();
    case PathKind::spline:
      return vo::require(!options.file.empty() || (options.eyes.size() >= 2 &&
                                                   options.eyes.size() == options.targets.size()),
                         "path: a spline expects at least two eyes and as many targets (or a "
                         "file), got ",
                         options.eyes.size(), " and ", options.targets.size());
    case PathKind::trajectory:
      return require_file(options);
    case PathKind::recorded:
      require_file(options);
      return options.recorded.validate();
    case PathKind::still:
    case PathKind::dolly:
    case PathKind::pan:
    case PathKind::roll:
      return options.move.validate();
    case PathKind::explore:
      return options.explore.validate();
  }
}

}  // namespace

void PathOptions::validate() const {
  vo::require(rate > 0, "path.rate: expected above 0, got ", rate);
  vo::require(duration > 0, "path.duration: expected above 0, got ", duration);
  vo::require(rate * duration < 1e6, "path: expected fewer than a million frames");
  chosen_format(*this);
  shake.validate();
  validate_kind(*this);
}

TimedPath make_path(const PathOptions& options, const SceneFile& scene) {
  options.validate();
  TimedPath result = steady_path(options, scene);
  if (options.shake.moves()) {
    result.path = with_hand_shake(result.path, options.shake);
  }
  require_within_reach(sample(result.path, result.times));
  return result;
}

vo::Trajectory make_trajectory(const PathOptions& options, const SceneFile& scene) {
  const TimedPath timed = make_path(options, scene);
  return sample(timed.path, timed.times);
}

}  // namespace synth
