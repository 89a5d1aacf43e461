#pragma once

#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "synth/camera_path.h"
#include "vo/core/trajectory.h"

namespace tools {

enum class PathKind {
  orbit,       ///< around a point
  spline,      ///< smooth, through poses: `eyes` and `targets`, or those of `file`
  trajectory,  ///< the poses of `file` as they are
};

constexpr auto enum_names(PathKind) {
  return std::array{std::pair{PathKind::orbit, "orbit"}, std::pair{PathKind::spline, "spline"},
                    std::pair{PathKind::trajectory, "trajectory"}};
}

struct PathOptions {
  PathKind kind = PathKind::orbit;
  double rate = 30;     ///< frames per second
  double duration = 5;  ///< s
  synth::OrbitOptions orbit;
  std::vector<Eigen::Vector3d> eyes;     ///< m, world; spread evenly over the duration
  std::vector<Eigen::Vector3d> targets;  ///< m, world; what the camera looks at from each eye
  std::filesystem::path file;            ///< TUM trajectory

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, PathOptions& options) {
  visit("kind", options.kind, "how the camera moves");
  visit("rate", options.rate, "frames per second (orbit, spline)");
  visit("duration", options.duration, "s (orbit, spline with eyes)");
  visit("orbit", options.orbit, "");
  visit("eyes", options.eyes, "camera positions of the spline, m, evenly spread over time");
  visit("targets", options.targets, "what the camera looks at from each of the eyes, m");
  visit("file", options.file, "TUM trajectory: the poses themselves, or the spline's");
}

/// T_world_camera of each frame.
vo::Trajectory make_trajectory(const PathOptions& options);

}  // namespace tools
