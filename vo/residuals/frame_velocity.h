#pragma once

#include <optional>

#include "vo/geometry/se3.h"

namespace vo {

/// The mean velocity between two frames, m/s and rad/s, in the camera's own frame.
struct MeanVelocity {
  Vector6d twist = Vector6d::Zero();
  double seconds = 0;  ///< s, time between the frames
};

/// The velocity while a frame is taken, m/s and rad/s, in the camera's own frame.
struct FrameVelocity {
  Vector6d twist = Vector6d::Zero();
  /// Uncertainty of the twist's linear and angular part, each in any direction.
  Vector6d doubt = Vector6d::Zero();
  /// Steady acceleration since the interval before, m/s^2 and rad/s^2; 0 where it is not known.
  Vector6d acceleration = Vector6d::Zero();
};

/// Extrapolates the last interval's mean velocity, which holds at its middle, to its end with the
/// steady acceleration since the interval before. The velocity's doubt is as large as that gain,
/// because a hand's acceleration changes from frame to frame: at 30 Hz a shake of 4 Hz is off by
/// 0.6 times the gain, one of 8 Hz by 1.2 times.
inline FrameVelocity velocity_at_end(const MeanVelocity& last,
                                     const std::optional<MeanVelocity>& before) {
  if (!before) {
    return {.twist = last.twist};
  }
  const double share = last.seconds / (last.seconds + before->seconds);
  const Vector6d gain = share * (last.twist - before->twist);
  return {last.twist + gain, gain, 2 / last.seconds * gain};
}

}  // namespace vo
