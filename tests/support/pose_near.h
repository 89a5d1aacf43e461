#pragma once

#include <numbers>
#include <ostream>

#include <gmock/gmock.h>

#include "vo/geometry/se3.h"

namespace vo {

inline void PrintTo(const SE3& T, std::ostream* out) {
  *out << "t = (" << T.translation().transpose() << ") m, q_xyzw = ("
       << T.rotation().coeffs().transpose() << ")";
}

}  // namespace vo

namespace support {

struct PoseTolerance {
  double translation_m = 0;
  double rotation_deg = 0;
};

MATCHER_P2(PoseNear, expected, tolerance, "is near " + testing::PrintToString(expected)) {
  const vo::SE3 difference = expected.inverse() * arg;
  const double distance = difference.translation().norm();
  const double angle_deg = difference.angle() * 180 / std::numbers::pi;
  *result_listener << "which is " << distance << " m and " << angle_deg << " deg away";
  return distance <= tolerance.translation_m && angle_deg <= tolerance.rotation_deg;
}

}  // namespace support
