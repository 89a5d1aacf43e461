#pragma once

#include <string>
#include <vector>

#include "synth/path_planning/path_options.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera.h"

namespace synth {

/// What a path must keep to. 0 = no limit.
struct PathLimits {
  double min_clearance = 0;       ///< m
  double min_depth_share = 0;     ///< of the pixels, in every frame
  double min_textured_share = 0;  ///< see synth::ViewContent; in every frame
  double max_speed = 0;           ///< m/s
  double max_turn_deg = 0;        ///< deg/s
  double max_acceleration = 0;    ///< m/s^2
  double max_flow_px = 0;         ///< of a frame's median

  void validate() const;  ///< throws vo::Error
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

/// A frame, and the way from it to the next one.
struct FrameCheck {
  double time = 0;            ///< s
  double clearance = 0;       ///< m, least on the way; 0 where a surface is met
  double speed = 0;           ///< m/s
  double turn_deg = 0;        ///< deg/s
  double acceleration = 0;    ///< m/s^2
  double depth_share = 0;     ///< of the pixels
  double textured_share = 0;  ///< of the tiles
  double flow_px = 0;         ///< median over the pixels with depth, to the next frame
};

struct Range {
  double min = 0;
  double median = 0;
  double max = 0;
};

struct PathReport {
  double duration = 0;  ///< s, from the first to the last frame
  double length = 0;    ///< m
  int collisions = 0;   ///< ways between frames that cross or touch a surface, moving or not
  int blank_views = 0;  ///< frames with contrast in fewer than a twentieth of their tiles
  std::vector<FrameCheck> frames;
  std::vector<std::string> violations;  ///< a sentence for each limit that is not kept
};

/// The range of one of a frame's values.
Range range_of(const std::vector<FrameCheck>& frames, double FrameCheck::*value);

/// Each frame sees the scene as it is then, its animations starting with the first frame. Clearance
/// is looked at eight times between frames; speeds and acceleration are central differences over 10
/// ms; the flow is that of pixels of a view 64 pixels wide by the camera's motion alone, in pixels
/// of `camera`.
PathReport check_path(const Scene& scene, const vo::PinholeCamera& camera, const TimedPath& timed,
                      const PathLimits& limits);

}  // namespace synth
