#include "vo/motion_files/trajectory_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "vo/core/error.h"
#include "vo/motion_files/timestamp.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

constexpr std::size_t kValues = 8;

using Values = std::array<double, kValues>;

Values first_values(const TextLine& line) {
  Values v{};
  for (std::size_t i = 0; i < kValues; ++i) {
    v.at(i) = parse_number(line, i);
  }
  return v;
}

/// Returns the pose of a stamp in units of `unit_s` seconds, a position and a quaternion, w last.
/// Throws Error if one of them is out of range.
StampedPose stamped_pose(const TextLine& line, const Values& v, double unit_s) {
  const double timestamp = parse_timestamp(line, 0, unit_s);
  return {timestamp, checked_pose(line.place(), {v[7], v[4], v[5], v[6]}, {v[1], v[2], v[3]})};
}

StampedPose parse_pose(const TextLine& line) {
  require(line.fields.size() == kValues, line.place(),
          ": expected 8 values (timestamp tx ty tz qx qy qz qw), got ", line.fields.size());
  return stamped_pose(line, first_values(line), 1);
}

StampedPose parse_euroc_pose(const TextLine& line) {
  require(line.fields.size() >= kValues, line.place(),
          ": expected at least 8 values (timestamp px py pz qw qx qy qz), got ",
          line.fields.size());
  const auto [ns, x, y, z, qw, qx, qy, qz] = first_values(line);
  return stamped_pose(line, {ns, x, y, z, qx, qy, qz, qw}, 1e-9);
}

template <typename ParsePose>
Trajectory read_poses(const std::filesystem::path& path, ParsePose parse) {
  const TextFile file(path);
  Trajectory trajectory;
  trajectory.reserve(file.line_count());
  file.for_each_line([&](const TextLine& line) {
    const StampedPose pose = parse(line);
    require(trajectory.empty() || pose.timestamp > trajectory.back().timestamp, line.place(),
            ": expected a stamp after the one before it, got ", line.fields[0]);
    trajectory.push_back(pose);
  });
  require(!trajectory.empty(), path.string(), ": holds no poses");
  return trajectory;
}

}  // namespace

SE3 checked_pose(const std::string& place, const Eigen::Quaterniond& rotation,
                 const Eigen::Vector3d& position) {
  constexpr double kUnitTolerance = 0.01;  // of a quaternion's norm from 1; files carry 4 decimals
  require(position.lpNorm<Eigen::Infinity>() < kMaxMetres, place, ": expected a position within ",
          kMaxMetres, " m of the origin");
  require(std::abs(rotation.norm() - 1) < kUnitTolerance, place,
          ": expected a quaternion of length 1, got length ", rotation.norm());
  return {rotation, position};
}

Trajectory read_trajectory(const std::filesystem::path& path) {
  return read_poses(path, parse_pose);
}

Trajectory read_euroc_trajectory(const std::filesystem::path& path) {
  return read_poses(path, parse_euroc_pose);
}

std::string format_euroc_pose(const StampedPose& pose) {
  const Eigen::Vector3d& t = pose.T_world_camera.translation();
  const Eigen::Quaterniond& q = pose.T_world_camera.rotation();
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), "%lld,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g",
                std::llround(pose.timestamp * 1e9), t.x(), t.y(), t.z(), q.w(), q.x(), q.y(),
                q.z());
  return line.data();
}

std::string format_trajectory(const Trajectory& trajectory) {
  std::vector<double> timestamps;
  for (const StampedPose& pose : trajectory) {
    timestamps.push_back(pose.timestamp);
  }
  const std::vector<std::string> stamps = format_timestamps(timestamps);
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

}  // namespace vo
