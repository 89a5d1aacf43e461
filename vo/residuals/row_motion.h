#pragma once

#include "vo/core/instruction_set.h"
#include "vo/geometry/se3.h"

namespace vo {

/// How a camera with a rolling shutter moves while it reads its rows from top to bottom, its
/// velocity times the read-out time. Frames are posed where their middle row is read; a point at p
/// in that camera is at p - s (w x p + v) in the camera of the row s image heights below the
/// middle. All in the camera's own frame; the velocity is constant while a frame is read.
struct RowMotion {
  Eigen::Vector3f linear = Eigen::Vector3f::Zero();   ///< v, m per image height
  Eigen::Vector3f angular = Eigen::Vector3f::Zero();  ///< w, rad per image height

  RowMotion() = default;

  /// `velocity`: twist [m/s; rad/s] of T_world_camera in the camera's frame; read-out time in s.
  RowMotion(const Vector6d& velocity, double readout)
      : linear((velocity.head<3>() * readout).cast<float>()),
        angular((velocity.tail<3>() * readout).cast<float>()) {}

  bool is_zero() const { return linear.isZero(0) && angular.isZero(0); }
};

/// How far below the middle row a row is, in image heights.
EDVO_INLINE float below_middle(float row, float inverse_height) {
  return (row + 0.5F) * inverse_height - 0.5F;
}

}  // namespace vo
