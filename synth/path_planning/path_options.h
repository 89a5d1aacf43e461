#pragma once

#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "synth/gltf/scene_file.h"
#include "synth/path/camera_move.h"
#include "synth/path/camera_path.h"
#include "synth/path/hand_shake.h"
#include "synth/path/recorded_path.h"
#include "synth/path_planning/explore.h"
#include "vo/geometry/trajectory.h"

namespace synth {

enum class PathKind {
  orbit,       ///< around a point
  spline,      ///< smooth, through poses: `eyes` and `targets`, or those of `file`
  trajectory,  ///< the poses of `file` as they are
  recorded,    ///< those of `file`, put into the scene and resampled
  still,       ///< at rest
  dolly,       ///< straight on
  pan,         ///< about the vertical
  roll,        ///< about the optical axis
  explore,     ///< through the scene's free space, as it finds it
};

constexpr auto enum_names(PathKind) {
  return std::array{std::pair{PathKind::orbit, "orbit"},
                    std::pair{PathKind::spline, "spline"},
                    std::pair{PathKind::trajectory, "trajectory"},
                    std::pair{PathKind::recorded, "recorded"},
                    std::pair{PathKind::still, "still"},
                    std::pair{PathKind::dolly, "dolly"},
                    std::pair{PathKind::pan, "pan"},
                    std::pair{PathKind::roll, "roll"},
                    std::pair{PathKind::explore, "explore"}};
}

struct PathOptions {
  PathKind kind = PathKind::orbit;
  double rate = 30;     ///< frames per second
  double duration = 5;  ///< s
  OrbitOptions orbit;
  std::vector<Eigen::Vector3d> eyes;     ///< m, world; spread evenly over the duration
  std::vector<Eigen::Vector3d> targets;  ///< m, world; what the camera looks at from each eye
  std::filesystem::path file;            ///< TUM trajectory, or EuRoC's where it ends in .csv
  RecordedOptions recorded;
  MoveOptions move;
  ExploreOptions explore;
  ShakeOptions shake;  ///< on top of any path

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, PathOptions& options) {
  visit("kind", options.kind, "how the camera moves");
  visit("rate", options.rate, "frames per second (all but trajectory)");
  visit("duration", options.duration, "s (all but trajectory, recorded and a spline of a file)");
  visit("orbit", options.orbit, "");
  visit("eyes", options.eyes, "camera positions of the spline, m, evenly spread over time");
  visit("targets", options.targets, "what the camera looks at from each of the eyes, m");
  visit("file", options.file, "TUM trajectory, or EuRoC's (.csv): the poses, or the spline's");
  visit("recorded", options.recorded, "");
  visit("move", options.move, "");
  visit("explore", options.explore, "");
  visit("shake", options.shake, "");
}

/// A motion without gaps and the times of its frames, s. It can be asked for any time between them.
struct TimedPath {
  CameraPath path;
  std::vector<double> times;
};

/// `scene` is read where the camera explores it; there it keeps clear of all places that moving
/// things come by.
TimedPath make_path(const PathOptions& options, const SceneFile& scene);

/// T_world_camera of each frame.
vo::Trajectory make_trajectory(const PathOptions& options, const SceneFile& scene);

}  // namespace synth
