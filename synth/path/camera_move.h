#pragma once

#include <Eigen/Core>

#include "synth/path/camera_path.h"

namespace synth {

/// A camera that starts at a pose and makes one move from rest to rest with continuous
/// acceleration. It rests before time 0 and after the duration.
struct MoveOptions {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();       ///< m, world; start position
  Eigen::Vector3d target = -Eigen::Vector3d::UnitZ();  ///< m, world; point looked at when it starts
  Eigen::Vector3d by = Eigen::Vector3d::UnitX();       ///< m, dolly, in the start pose's axes
  double turn_deg = 45;                                ///< deg, pan to the left, or roll clockwise
  double ramp = 0.5;                                   ///< s, to speed up, and again to slow down

  void validate() const;  ///< throws vo::Error if out of range
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

/// Returns a path that translates the camera by `options.by` without turning it.
CameraPath dolly(const MoveOptions& options, double duration_s);

/// Returns a path that turns the camera about the world's vertical through its position.
CameraPath pan(const MoveOptions& options, double duration_s);

/// Returns a path that turns the camera about its optical axis.
CameraPath roll(const MoveOptions& options, double duration_s);

}  // namespace synth
