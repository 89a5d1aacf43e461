#pragma once

#include <array>
#include <utility>

#include "vo/core/instruction_set.h"
#include "vo/geometry/se3.h"

namespace vo {

/// The lines that a rolling shutter reads one after the other. They are columns where a camera is
/// mounted turned by 90 degrees and its images are turned back.
enum class ReadoutAxis { rows, columns };

constexpr auto enum_names(ReadoutAxis) {
  return std::array{std::pair{ReadoutAxis::rows, "rows"},
                    std::pair{ReadoutAxis::columns, "columns"}};
}

/// The longest read-out time, s, of either sign.
inline constexpr double kMaxReadout = 0.1;

/// The read-out of a rolling shutter. A global shutter's takes 0 s.
struct Readout {
  double seconds =
      0;  ///< from the first to the last line; negative where the last one is read first
  ReadoutAxis axis = ReadoutAxis::rows;

  bool is_rolling() const { return seconds != 0; }
};

/// A camera's motion while a rolling shutter reads an image: its velocity times the read-out time.
/// A frame's pose is that of its middle line. In the camera of the line that is s of the image's
/// height or width past the middle, a point that is at p in the middle line's camera is at
/// p - s (w x p + v). All are in the camera's own frame; the velocity is constant while a frame is
/// read.
struct ReadoutMotion {
  Eigen::Vector3f linear = Eigen::Vector3f::Zero();   ///< v, m per read-out
  Eigen::Vector3f angular = Eigen::Vector3f::Zero();  ///< w, rad per read-out
  ReadoutAxis axis = ReadoutAxis::rows;

  ReadoutMotion() = default;

  /// Takes a velocity, the twist [m/s; rad/s] of T_world_camera in the camera's frame.
  ReadoutMotion(const Vector6d& velocity, const Readout& readout)
      : linear((velocity.head<3>() * readout.seconds).cast<float>()),
        angular((velocity.tail<3>() * readout.seconds).cast<float>()),
        axis(readout.axis) {}

  bool is_zero() const { return linear.isZero(0) && angular.isZero(0); }
};

/// A read-out time shorter than this, s, of either sign, is the noise of a global shutter's where
/// depths were found together with it.
inline constexpr double kLeastMappedReadout = 3e-3;

/// Returns how far past the image's middle a row or a column is, as a share of the image's height
/// or width.
EDVO_INLINE float past_middle(float line, float inverse_size) {
  return (line + 0.5F) * inverse_size - 0.5F;
}

}  // namespace vo
