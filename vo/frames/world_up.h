#pragma once

#include <array>
#include <numbers>
#include <utility>

#include "vo/geometry/se3.h"

namespace vo {

/// The axis of a sequence's world that points up.
enum class WorldUp {
  unknown,
  y,        ///< glTF's and this project's
  z,        ///< EuRoC's, Nerfstudio's
  minus_y,  ///< that of TartanAir, whose z points down, once its axes are this project's
};

constexpr auto enum_names(WorldUp) {
  return std::array{std::pair{WorldUp::unknown, "unknown"}, std::pair{WorldUp::y, "y"},
                    std::pair{WorldUp::z, "z"}, std::pair{WorldUp::minus_y, "-y"}};
}

/// Returns the rotation about x that takes the coordinates of a world with one axis up to those of
/// a world with another up. Neither may be unknown.
inline SE3 turn_of_world(WorldUp from, WorldUp to) {
  const auto quarters = [](WorldUp up) { return up == WorldUp::y ? 0 : up == WorldUp::z ? 1 : 2; };
  const double angle = (quarters(to) - quarters(from)) * std::numbers::pi / 2;
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX())),
          Eigen::Vector3d::Zero()};
}

}  // namespace vo
