#pragma once

#include <filesystem>
#include <string>

#include "vo/geometry/trajectory.h"

namespace vo {

/// TUM format: `timestamp tx ty tz qx qy qz qw` of T_world_camera, seconds and metres, '#' starts a
/// comment. Throws Error naming file and line: numbers that are missing, not finite or not a
/// rotation, and stamps that do not increase.
Trajectory read_trajectory(const std::filesystem::path& path);

/// EuRoC's ground truth: `timestamp px py pz qw qx qy qz ...` of T_world_body, nanoseconds and
/// metres, whatever follows left out. Errors as above.
Trajectory read_euroc_trajectory(const std::filesystem::path& path);

/// A line of that format, without velocity and biases.
std::string format_euroc_pose(const StampedPose& pose);

/// The TUM format with 6 decimals of a second and 9 decimals of a pose.
std::string format_trajectory(const Trajectory& trajectory);

}  // namespace vo
