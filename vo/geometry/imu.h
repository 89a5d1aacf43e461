#pragma once

#include <vector>

#include <Eigen/Core>

#include "vo/geometry/se3.h"

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

/// The densities of its noise, and of the noise that its biases walk by; 0 = none, or unknown.
struct ImuNoise {
  double rate = 0;             ///< Hz, of the samples
  double gyro_noise = 0;       ///< rad/s/sqrt(Hz)
  double gyro_bias_walk = 0;   ///< rad/s^2/sqrt(Hz)
  double accel_noise = 0;      ///< m/s^2/sqrt(Hz)
  double accel_bias_walk = 0;  ///< m/s^3/sqrt(Hz)
};

template <typename Visitor>
void visit_fields(Visitor& visit, ImuNoise& noise) {
  visit("rate", noise.rate, "samples per second");
  visit("gyro_noise", noise.gyro_noise, "white noise density, rad/s/sqrt(Hz)");
  visit("gyro_bias_walk", noise.gyro_bias_walk, "density of the bias's walk, rad/s^2/sqrt(Hz)");
  visit("accel_noise", noise.accel_noise, "white noise density, m/s^2/sqrt(Hz)");
  visit("accel_bias_walk", noise.accel_bias_walk, "density of the bias's walk, m/s^3/sqrt(Hz)");
}

/// What a unit on a body read, and the truth at the same instants.
struct ImuRecord {
  std::vector<ImuSample> samples;
  std::vector<BodyState> states;
  ImuNoise noise;
};

}  // namespace vo
