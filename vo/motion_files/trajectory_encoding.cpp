#include <array>
#include <cinttypes>
#include <cstdio>

#include "vo/geometry/associate.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"

namespace vo {
std::string format_euroc_pose(const StampedPose& pose) {
  const Eigen::Vector3d& t = pose.T_world_camera.translation();
  const Eigen::Quaterniond& q = pose.T_world_camera.rotation();
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), "%" PRId64 ",%.12g,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g",
                to_nanoseconds(pose.timestamp), t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z());
  return line.data();
}

std::string format_euroc_trajectory(const Trajectory& trajectory) {
  std::string text =
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],"
      "q_RS_z []\n";
  for (const StampedPose& pose : trajectory) {
    text += format_euroc_pose(pose) + "\n";
  }
  return text;
}

std::string format_trajectory(const Trajectory& trajectory) {
  const std::vector<std::string> stamps = format_timestamps(timestamps_of(trajectory));
  std::string text = "# timestamp tx ty tz qx qy qz qw\n";
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Eigen::Vector3d& t = trajectory[i].T_world_camera.translation();
    const Eigen::Quaterniond& q = trajectory[i].T_world_camera.rotation();
    text += stamps[i];
    for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
      std::array<char, 400> number{};  // the greatest double has 309 digits
      std::snprintf(number.data(), number.size(), " %.9f", value);
      text += number.data();
    }
    text += "\n";
  }
  return text;
}

std::string format_kitti_poses(const Trajectory& trajectory) {
  std::string text;
  for (const StampedPose& pose : trajectory) {
    Eigen::Matrix<double, 3, 4> rows;
    rows << pose.T_world_camera.rotation_matrix(), pose.T_world_camera.translation();
    for (int i = 0; i < 12; ++i) {
      std::array<char, 40> number{};
      std::snprintf(number.data(), number.size(), "%s%.12g", i == 0 ? "" : " ", rows(i / 4, i % 4));
      text += number.data();
    }
    text += "\n";
  }
  return text;
}

std::string format_kitti_times(const Trajectory& trajectory) {
  std::string text;
  for (const std::string& stamp : format_timestamps(timestamps_of(trajectory))) {
    text += stamp + "\n";
  }
  return text;
}

}  // namespace vo
