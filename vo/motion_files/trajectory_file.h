#pragma once

#include <filesystem>
#include <string>

#include "vo/geometry/trajectory.h"

namespace vo {

/// The greatest distance of a file from the origin, m, along each axis.
inline constexpr double kMaxMetres = 1e9;

/// Returns a pose that a file holds. Throws Error beginning with `place` if the position is not
/// within `kMaxMetres` or the quaternion's length differs from 1 by 0.01 or more.
SE3 checked_pose(const std::string& place, const Eigen::Quaterniond& rotation,
                 const Eigen::Vector3d& position);

/// Reads a file in the TUM format: `timestamp tx ty tz qx qy qz qw` of T_world_camera, seconds and
/// metres, '#' starts a comment. Throws Error naming file and line: numbers that are missing, not
/// finite or not a rotation, and stamps that do not increase.
Trajectory read_trajectory(const std::filesystem::path& path);

/// Reads EuRoC's ground truth: `timestamp px py pz qw qx qy qz ...` of T_world_body, nanoseconds
/// and metres; what follows is ignored. Throws Error as `read_trajectory` does.
Trajectory read_euroc_trajectory(const std::filesystem::path& path);

/// Returns a pose of the body as a line of EuRoC's ground truth without velocity, biases and
/// newline.
std::string format_euroc_pose(const StampedPose& pose);

/// Returns a trajectory in the TUM format, its stamps as `format_timestamps` has them and 9
/// decimals of a pose.
std::string format_trajectory(const Trajectory& trajectory);

}  // namespace vo
