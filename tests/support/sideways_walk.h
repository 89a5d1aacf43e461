#pragma once

#include <cmath>

#include "vo/geometry/se3.h"

namespace support {

/// Sideways past the textured plane at 2 m, 1.5 cm a frame, swaying a little.
inline vo::SE3 sideways_walk(int frame) {
  return vo::SE3::exp((vo::Vector6d() << 0.015 * frame, 0.01 * std::sin(0.3 * frame), 0.002 * frame,
                       0.01 * std::sin(0.2 * frame), 0.002 * frame, 0)
                          .finished());
}

/// So many frames of it have a parallax between the 2 px that an unknown start needs at a width of
/// 320 px and the 12.5 px that it waits for, and are too few for its patience to end.
inline constexpr int kShortWalk = 24;

}  // namespace support
