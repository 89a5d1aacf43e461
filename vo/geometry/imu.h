#pragma once

#include <vector>

#include <Eigen/Core>

#include "vo/geometry/se3.h"

namespace vo {

/// One reading of an inertial measurement unit (IMU), in the axes of the IMU.
struct ImuSample {
  double timestamp = 0;                                        ///< s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s
  Eigen::Vector3d specific_force =
      Eigen::Vector3d::Zero();  ///< m/s^2, acceleration minus gravity: upwards at rest
};

/// Motion of a body and the biases of the IMU that is mounted on it.
struct BodyState {
  double timestamp = 0;  ///< s
  SE3 T_world_body;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();    ///< m/s, in the world frame
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();   ///< rad/s, of the gyroscope
  Eigen::Vector3d accel_bias = Eigen::Vector3d::Zero();  ///< m/s^2, of the accelerometer
};

/// Noise densities of an IMU and of the random walks of its biases; 0 = none, or unknown.
struct ImuNoise {
  double rate = 0;             ///< Hz, sampling rate
  double gyro_noise = 0;       ///< rad/s/sqrt(Hz), white noise
  double gyro_bias_walk = 0;   ///< rad/s^2/sqrt(Hz), random walk of the bias
  double accel_noise = 0;      ///< m/s^2/sqrt(Hz), white noise
  double accel_bias_walk = 0;  ///< m/s^3/sqrt(Hz), random walk of the bias
};

template <typename Visitor>
void visit_fields(Visitor& visit, ImuNoise& noise) {
  visit("rate", noise.rate, "samples per second");
  visit("gyro_noise", noise.gyro_noise, "white noise density, rad/s/sqrt(Hz)");
  visit("gyro_bias_walk", noise.gyro_bias_walk, "density of the bias's walk, rad/s^2/sqrt(Hz)");
  visit("accel_noise", noise.accel_noise, "white noise density, m/s^2/sqrt(Hz)");
  visit("accel_bias_walk", noise.accel_bias_walk, "density of the bias's walk, m/s^3/sqrt(Hz)");
}

/// The readings of an IMU on a body, and the body's true states at those instants.
struct ImuRecord {
  std::vector<ImuSample> samples;
  std::vector<BodyState> states;
  ImuNoise noise;
};

}  // namespace vo
