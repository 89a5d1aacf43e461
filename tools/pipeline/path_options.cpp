#include "tools/pipeline/path_options.h"

#include "vo/core/error.h"
#include "vo/io/trajectory_file.h"

namespace tools {
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

/// The spline through the poses of a file, over their own time span.
vo::Trajectory resampled(const vo::Trajectory& poses, double rate) {
  vo::require(poses.size() >= 2, "path.file: expected at least two poses for a spline");
  vo::Trajectory shifted = poses;
  for (vo::StampedPose& pose : shifted) {
    pose.timestamp -= poses.front().timestamp;
  }
  vo::Trajectory sampled = synth::sample(synth::spline(shifted), rate, shifted.back().timestamp);
  for (vo::StampedPose& pose : sampled) {
    pose.timestamp += poses.front().timestamp;
  }
  return sampled;
}

}  // namespace

void PathOptions::validate() const {
  vo::require(rate > 0, "path.rate: expected above 0, got ", rate);
  vo::require(duration > 0, "path.duration: expected above 0, got ", duration);
  vo::require(rate * duration < 1e6, "path: expected fewer than a million frames");
  if (kind == PathKind::orbit) {
    orbit.validate();
  }
  if (kind == PathKind::trajectory) {
    vo::require(!file.empty(), "path.file: expected a trajectory file");
  }
  if (kind == PathKind::spline && file.empty()) {
    vo::require(eyes.size() >= 2 && eyes.size() == targets.size(),
                "path: a spline expects at least two eyes and as many targets (or a file), got ",
                eyes.size(), " and ", targets.size());
  }
}

vo::Trajectory make_trajectory(const PathOptions& options) {
  options.validate();
  switch (options.kind) {
    case PathKind::orbit:
      return synth::sample(synth::orbit(options.orbit), options.rate, options.duration);
    case PathKind::spline:
      return options.file.empty() ? synth::sample(synth::spline(control_poses(options)),
                                                  options.rate, options.duration)
                                  : resampled(vo::read_trajectory(options.file), options.rate);
    case PathKind::trajectory:
      return vo::read_trajectory(options.file);
  }
  return {};
}

}  // namespace tools
