#pragma once

#include <array>
#include <utility>

namespace vo {

class TextFile;
struct TextLine;

/// The formats of trajectories that are read.
enum class TrajectoryFormat {
  tum,       ///< `timestamp tx ty tz qx qy qz qw` of T_world_camera, s and m
  euroc,     ///< `timestamp,px,py,pz,qw,qx,qy,qz,...` of T_world_body, ns and m
  kitti,     ///< the upper three rows of T_world_camera, m, row by row and without stamps
  orb_slam,  ///< as `tum` but with stamps in ns, as ORB-SLAM3 writes it for EuRoC
  colmap,    ///< COLMAP's images.txt: T_camera_world of images, which have names and no stamps
  mcap,      ///< a topic of an MCAP file, vo/motion_files/recorded_trajectory.h
  bag,       ///< a topic of a ROS 1 bag
};

constexpr auto enum_names(TrajectoryFormat) {
  return std::array{std::pair{TrajectoryFormat::tum, "tum"},
                    std::pair{TrajectoryFormat::euroc, "euroc"},
                    std::pair{TrajectoryFormat::kitti, "kitti"},
                    std::pair{TrajectoryFormat::orb_slam, "orb-slam"},
                    std::pair{TrajectoryFormat::colmap, "colmap"},
                    std::pair{TrajectoryFormat::mcap, "mcap"},
                    std::pair{TrajectoryFormat::bag, "bag"}};
}

/// Returns whether a line that has values begins with a whole number and a comma, as a stamp in ns
/// does in EuRoC's files.
bool begins_as_euroc(const TextLine& line);

/// Returns the format of a trajectory's file by the first line that is neither empty nor a comment:
/// 12 numbers are KITTI's, 9 numbers and a name COLMAP's, a whole number and more behind a comma
/// EuRoC's, and 8 numbers TUM's, or ORB-SLAM's where the first is no number of seconds. Throws
/// Error naming file and line if it is none of them, and the file if there is no such line.
TrajectoryFormat recognise_trajectory(const TextFile& file);

}  // namespace vo
