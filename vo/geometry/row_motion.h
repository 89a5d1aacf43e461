#pragma once

#include "vo/core/instruction_set.h"
#include "vo/geometry/se3.h"

namespace vo {

/// A rolling-shutter camera's motion while it reads its rows from top to bottom: its velocity times
/// the read-out time. A frame's pose is that of its middle row. In the camera of the row s image
/// heights below, a point that is at p in the middle row's camera is at p - s (w x p + v). All are
/// in the camera's own frame; the velocity is constant while a frame is read.
struct RowMotion {
  Eigen::Vector3f linear = Eigen::Vector3f::Zero();   ///< v, m per image height
  Eigen::Vector3f angular = Eigen::Vector3f::Zero();  ///< w, rad per image height

  RowMotion() = default;

  /// Takes a velocity, the twist [m/s; rad/s] of T_world_camera in the camera's frame, and a
  /// read-out time in s.
  RowMotion(const Vector6d& velocity, double readout)
      : linear((velocity.head<3>() * readout).cast<float>()),
        angular((velocity.tail<3>() * readout).cast<float>()) {}

  bool is_zero() const { return linear.isZero(0) && angular.isZero(0); }
};

/// A read-out time shorter than this is noise of a global shutter's where depths were found
/// together with it, s.
inline constexpr double kLeastMappedReadout = 3e-3;

/// Returns how far below the middle row a row is, in image heights.
EDVO_INLINE float below_middle(float row, float inverse_height) {
  return (row + 0.5F) * inverse_height - 0.5F;
}

}  // namespace vo
