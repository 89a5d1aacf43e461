#pragma once

#include <array>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "vo/geometry/trajectory.h"

namespace synth {

enum class UpAxis { y, z };

constexpr auto enum_names(UpAxis) {
  return std::array{std::pair{UpAxis::y, "y"}, std::pair{UpAxis::z, "z"}};
}

/// The placement of a recording in a scene: p_scene = by + scale R_y(turn) R_up p_recording, where
/// R_up takes the recording's `up` to the scene's y. The defaults leave it unchanged.
struct RecordedOptions {
  UpAxis up = UpAxis::y;                         ///< vertical axis of the recording's world
  double scale = 1;                              ///< factor of the recorded positions
  double turn_deg = 0;                           ///< deg, counter-clockwise seen from above
  Eigen::Vector3d by = Eigen::Vector3d::Zero();  ///< m, translation in the scene
  std::string body_camera;  ///< T_body_camera where poses are a body's: x,y,z,qx,qy,qz,qw

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, RecordedOptions& options) {
  visit("up", options.up, "the axis that points up in the recording's world");
  visit("scale", options.scale, "of the recording's positions");
  visit("turn_deg", options.turn_deg, "then about the vertical, counter-clockwise from above, deg");
  visit("by", options.by, "then along the scene's axes, m");
  visit("body_camera", options.body_camera, "T_body_camera of a body's poses: x,y,z,qx,qy,qz,qw");
}

/// Returns T_scene_camera of each recorded pose, at its time.
vo::Trajectory placed(const vo::Trajectory& recording, const RecordedOptions& options);

}  // namespace synth
