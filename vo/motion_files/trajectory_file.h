#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vo/geometry/trajectory.h"
#include "vo/geometry/world_extent.h"
#include "vo/motion_files/trajectory_format.h"

namespace vo {

/// Returns a pose that a file holds. Throws Error beginning with `place` if the position is not
/// within `kMaxMetres` or the quaternion's length differs from 1 by 0.01 or more.
SE3 checked_pose(const std::string& place, const Eigen::Quaterniond& rotation,
                 const Eigen::Vector3d& position);

/// Returns a pose that a file holds as the upper three rows of its matrix. Throws Error beginning
/// with `place` if the position is not within `kMaxMetres` or the rotation, times its transpose,
/// differs from 1 by 0.01 or more.
SE3 checked_pose(const std::string& place, const Eigen::Matrix<double, 3, 4>& rows);

/// What is known of a trajectory's file beside its content.
struct TrajectoryReading {
  std::optional<TrajectoryFormat> format;  ///< as `recognise_trajectory` finds it if absent
  std::filesystem::path times;             ///< list as FrameTimes reads it; empty without one
};

/// A trajectory as it was read. Its poses are T_world_camera, or T_world_body of formats that have
/// those.
struct TrajectoryFile {
  TrajectoryFormat format = TrajectoryFormat::tum;
  Trajectory trajectory;
  std::vector<std::string> notes;  ///< sentences on what was not as the format has it
};

/// Reads a trajectory. Of several poses with one stamp the first counts; stamps that go back by at
/// most 0.5 s are sorted. The path of a recording may have a topic behind it, as `recording_name`
/// and `read_recorded_trajectory` have it. KITTI's poses without `times` are 0.1 s apart; COLMAP's
/// have their stamps as `read_colmap_images` says. Throws Error naming file and line.
TrajectoryFile read_trajectory_file(const std::filesystem::path& path,
                                    const TrajectoryReading& reading = {});

/// Returns the poses alone of `read_trajectory_file`.
Trajectory read_trajectory(const std::filesystem::path& path);

/// Reads a sequence's own trajectory, of which the format is known, and appends to `notes`.
Trajectory read_truth(const std::filesystem::path& path, TrajectoryFormat format,
                      std::vector<std::string>& notes);

/// Returns a pose of the body as a line of EuRoC's ground truth without velocity, biases and
/// newline.
std::string format_euroc_pose(const StampedPose& pose);

/// Returns a trajectory as EuRoC's ground truth without velocity and biases.
std::string format_euroc_trajectory(const Trajectory& trajectory);

/// Returns a trajectory in the TUM format, its stamps as `format_timestamps` has them and 9
/// decimals of a pose.
std::string format_trajectory(const Trajectory& trajectory);

/// Returns a trajectory's poses in KITTI's format, and its stamps as KITTI's times.txt.
std::string format_kitti_poses(const Trajectory& trajectory);
std::string format_kitti_times(const Trajectory& trajectory);

}  // namespace vo
