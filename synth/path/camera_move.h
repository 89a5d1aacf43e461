#pragma once

#include <Eigen/Core>

#include "synth/path/camera_path.h"

namespace synth {

/// A camera that starts at a pose and moves in one way, from rest to rest: it speeds up and slows
/// down so that its acceleration is continuous. It rests before time 0 and after the duration.
struct MoveOptions {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();  ///< m, world; where it starts
  Eigen::Vector3d target =
      -Eigen::Vector3d::UnitZ();                  ///< m, world; what it looks at when it starts
  Eigen::Vector3d by = Eigen::Vector3d::UnitX();  ///< m, in the start pose's axes; dolly
  double turn_deg = 45;                           ///< to the left (pan), clockwise (roll)
  double ramp = 0.5;                              ///< s, to speed up, and to slow down

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, MoveOptions& options) {
  visit("eye", options.eye, "where the camera starts, m");
  visit("target", options.target, "what it looks at when it starts, m");
  visit("by", options.by, "dolly: how far, along the first view's right, down and forward, m");
  visit("turn_deg", options.turn_deg, "pan: to the left; roll: of the camera clockwise, deg");
  visit("ramp", options.ramp, "to speed up at the start, and to slow down at the end, s");
}

CameraPath still(const MoveOptions& options);

/// Straight on, without turning.
CameraPath dolly(const MoveOptions& options, double duration_s);

/// About the world's vertical through the camera.
CameraPath pan(const MoveOptions& options, double duration_s);

/// About the optical axis.
CameraPath roll(const MoveOptions& options, double duration_s);

}  // namespace synth
