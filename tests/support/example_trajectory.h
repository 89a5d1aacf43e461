#pragma once

#include <cmath>

#include "vo/geometry/trajectory.h"

namespace support {

/// A smooth hand-held motion: a position that wanders over a metre and a rotation of up to 30 deg.
inline vo::SE3 example_pose(double time) {
  const Eigen::Vector3d rotation(0.4 * std::sin(1.3 * time), 0.5 * std::sin(0.7 * time + 1),
                                 0.3 * std::cos(1.9 * time));
  const Eigen::Vector3d position(std::sin(0.9 * time), 0.6 * std::cos(1.4 * time),
                                 0.4 * std::sin(2.1 * time + 2));
  vo::Vector6d tangent;
  tangent << Eigen::Vector3d::Zero(), rotation;
  return {vo::SE3::exp(tangent).rotation(), position};
}

/// `count` poses of it from `start`, a whole number of them a second.
inline vo::Trajectory example_trajectory(std::size_t count, int poses_per_second,
                                         double start = 0) {
  vo::Trajectory trajectory;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = start + static_cast<double>(i) / poses_per_second;
    trajectory.push_back({time, example_pose(time)});
  }
  return trajectory;
}

/// The trajectory with T_a_b * T_world_camera for poses.
inline vo::Trajectory moved(const vo::SE3& T_a_b, vo::Trajectory trajectory) {
  for (vo::StampedPose& pose : trajectory) {
    pose.T_world_camera = T_a_b * pose.T_world_camera;
  }
  return trajectory;
}

/// The trajectory with stamps that are `shift` later.
inline vo::Trajectory delayed(vo::Trajectory trajectory, double shift) {
  for (vo::StampedPose& pose : trajectory) {
    pose.timestamp += shift;
  }
  return trajectory;
}

/// The trajectory with each pose followed by the motion of a constant velocity, from the first.
inline vo::Trajectory drifting(vo::Trajectory trajectory, const vo::Vector6d& velocity) {
  const double start = trajectory.front().timestamp;
  for (auto& [timestamp, T_world_camera] : trajectory) {
    T_world_camera = T_world_camera * vo::SE3::exp((timestamp - start) * velocity);
  }
  return trajectory;
}

}  // namespace support
