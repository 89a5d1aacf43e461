#pragma once

#include <vector>

#include <Eigen/Core>

#include "vo/core/se3.h"

namespace vo {

/// What an inertial measurement unit reads, in its own axes.
struct ImuSample {
  double timestamp = 0;                                        ///< s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s
  Eigen::Vector3d specific_force =
      Eigen::Vector3d::Zero();  ///< m/s^2: acceleration less gravity, upwards at rest
};

/// How a body moves.
struct BodyState {
  double timestamp = 0;  ///< s
  SE3 T_world_body;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();    ///< m/s, world
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();   ///< rad/s, of the unit on it
  Eigen::Vector3d accel_bias = Eigen::Vector3d::Zero();  ///< m/s^2, of the unit on it
};

/// What a unit on a body read, and the truth at the same instants.
struct ImuRecord {
  std::vector<ImuSample> samples;
  std::vector<BodyState> states;
};

}  // namespace vo
