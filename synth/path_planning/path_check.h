#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "synth/path_planning/path_options.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera_model.h"

namespace synth {

/// The limits that a path must keep; 0 = no limit.
struct PathLimits {
  double min_clearance = 0;       ///< m, to any surface
  double min_depth_share = 0;     ///< share of pixels with depth, in every frame
  double min_textured_share = 0;  ///< ViewContent::textured_share, in every frame
  double max_speed = 0;           ///< m/s
  double max_turn_deg = 0;        ///< deg/s, angular speed
  double max_acceleration = 0;    ///< m/s^2
  double max_flow_px = 0;         ///< px, median optical flow of a frame

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, PathLimits& limits) {
  visit("min_clearance", limits.min_clearance, "to any surface, m");
  visit("min_depth_share", limits.min_depth_share, "pixels with depth, share, in every frame");
  visit("min_textured_share", limits.min_textured_share, "tiles with contrast, in every frame");
  visit("max_speed", limits.max_speed, "m/s");
  visit("max_turn_deg", limits.max_turn_deg, "angular speed, deg/s");
  visit("max_acceleration", limits.max_acceleration, "m/s^2");
  visit("max_flow_px", limits.max_flow_px, "a frame's median optical flow, px");
}

/// Measurements of a frame and of the motion from it to the next one.
struct FrameCheck {
  double time = 0;            ///< s
  double clearance = 0;       ///< m, least until the next frame; 0 = collision
  double speed = 0;           ///< m/s
  double turn_deg = 0;        ///< deg/s, angular speed
  double acceleration = 0;    ///< m/s^2
  double depth_share = 0;     ///< share of pixels with depth
  double textured_share = 0;  ///< share of textured tiles
  double flow_px = 0;         ///< px, median optical flow to the next frame
};

struct Range {
  double min = 0;
  double median = 0;
  double max = 0;
};

struct PathReport {
  double duration = 0;  ///< s, from the first to the last frame
  double length = 0;    ///< m, sum of the distances between frames
  int collisions = 0;   ///< frame intervals in which the camera touches or crosses a surface
  int blank_views = 0;  ///< frames with contrast in fewer than a twentieth of their tiles
  std::vector<FrameCheck> frames;
  std::vector<std::string> violations;  ///< a message for each limit that is not kept
};

/// Returns the range of one measured value over all frames.
Range range_of(const std::vector<FrameCheck>& frames, double FrameCheck::*value);

/// The frames [first, end) of a path.
struct FrameRange {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// Measures some frames of a path, each as `check_path` does.
std::vector<FrameCheck> check_frames(const Scene& scene, const vo::CameraModel& camera,
                                     const TimedPath& timed, const FrameRange& range);

/// Checks a path against limits. Each frame sees the scene at its time, animations starting with
/// the first frame. Clearance is sampled in eight steps between frames; speeds and acceleration are
/// central differences over 10 ms; flow is that of a view 64 pixels wide by the camera's motion
/// alone, in pixels of `camera`.
PathReport check_path(const Scene& scene, const vo::CameraModel& camera, const TimedPath& timed,
                      const PathLimits& limits);

}  // namespace synth
