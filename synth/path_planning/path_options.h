#pragma once

#include <array>
#include <filesystem>
#include <string>
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
  orbit,       ///< circle around a point
  spline,      ///< smooth path through `eyes` and `targets`, or the poses of `file`
  trajectory,  ///< the poses of `file` as they are
  recorded,    ///< poses of `file`, placed in the scene and resampled
  still,       ///< camera at rest
  dolly,       ///< straight translation
  pan,         ///< rotation about the vertical
  roll,        ///< rotation about the optical axis
  explore,     ///< automatically planned path through the scene's free space
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
  double duration = 5;  ///< s, length of the path in time
  OrbitOptions orbit;
  std::vector<Eigen::Vector3d> eyes;     ///< m, world; camera positions, evenly spread over time
  std::vector<Eigen::Vector3d> targets;  ///< m, world; what the camera looks at from each eye
  std::filesystem::path file;            ///< trajectory of any TrajectoryFormat
  std::string file_format;               ///< name of a TrajectoryFormat; empty: as it is recognised
  std::filesystem::path file_times;  ///< stamps of a file without: a list as vo::FrameTimes reads
  RecordedOptions recorded;
  MoveOptions move;
  ExploreOptions explore;
  ShakeOptions shake;  ///< hand shake added to any path

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, PathOptions& options) {
  visit("kind", options.kind, "how the camera moves");
  visit("rate", options.rate, "frames per second (all but trajectory)");
  visit("duration", options.duration, "s (all but trajectory, recorded and a spline of a file)");
  visit("orbit", options.orbit, "");
  visit("eyes", options.eyes, "camera positions of the spline, m, evenly spread over time");
  visit("targets", options.targets, "what the camera looks at from each of the eyes, m");
  visit("file", options.file, "trajectory of any format that is read: the poses, or the spline's");
  visit("file_format", options.file_format, "of the file; empty: recognised by its content");
  visit("file_times", options.file_times, "list of stamps for a file without");
  visit("recorded", options.recorded, "");
  visit("move", options.move, "");
  visit("explore", options.explore, "");
  visit("shake", options.shake, "");
}

/// A continuous camera path and the times of its frames, s.
struct TimedPath {
  CameraPath path;
  std::vector<double> times;
};

/// Returns the path and its frames' times. `scene` is read only for PathKind::explore, where the
/// path keeps clear of `with_traces`. Throws vo::Error for invalid options.
TimedPath make_path(const PathOptions& options, const SceneFile& scene);

/// Returns T_world_camera of each frame.
vo::Trajectory make_trajectory(const PathOptions& options, const SceneFile& scene);

}  // namespace synth
