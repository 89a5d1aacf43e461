#include "vo/motion_files/trajectory_file.h"

#include <array>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/geometry/unit_quaternion.h"
#include "vo/motion_files/colmap_images.h"
#include "vo/motion_files/frame_times.h"
#include "vo/motion_files/pose_collector.h"
#include "vo/motion_files/recorded_trajectory.h"
#include "vo/motion_files/timestamp.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

constexpr double kKittiInterval = 0.1;   // s, between frames of its cameras
constexpr double kUnitTolerance = 0.01;  // of a rotation from 1; files carry 4 decimals

template <std::size_t kCount>
std::array<double, kCount> first_values(const TextLine& line) {
  std::array<double, kCount> values{};
  for (std::size_t i = 0; i < kCount; ++i) {
    values.at(i) = parse_number(line, i);
  }
  return values;
}

void require_within_reach(const std::string& place, const Eigen::Vector3d& position) {
  require(position.lpNorm<Eigen::Infinity>() < kMaxMetres, place, ": expected a position within ",
          kMaxMetres, " m of the origin");
}

/// Returns the pose of a line in TUM's format with stamps in units of `unit_s` seconds.
StampedPose parse_tum_pose(const TextLine& line, double unit_s) {
  const auto [stamp, x, y, z, qx, qy, qz, qw] = first_values<8>(line);
  return {checked_timestamp(line, stamp * unit_s),
          checked_pose(line.place(), {qw, qx, qy, qz}, {x, y, z})};
}

StampedPose parse_euroc_pose(const TextLine& line) {
  const auto [_, x, y, z, qw, qx, qy, qz] = first_values<8>(line);
  return {parse_nanoseconds(line, 0), checked_pose(line.place(), {qw, qx, qy, qz}, {x, y, z})};
}

SE3 parse_kitti_pose(const TextLine& line) {
  require(line.fields.size() == 12, line.place(),
          ": expected 12 values (the upper three rows of a pose's matrix), got ",
          line.fields.size());
  const std::array<double, 12> values = first_values<12>(line);
  return checked_pose(
      line.place(), Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(values.data()));
}

/// Reads poses with stamps, one a line, each by `parse`.
template <typename ParsePose>
Trajectory read_lines(const TextFile& file, std::vector<std::string>& notes, ParsePose parse) {
  PoseCollector poses(file.path(), PoseCollector::Order::of_time);
  poses.reserve(file.line_count());
  file.for_each_line([&](const TextLine& line) { poses.add(parse(line), line); });
  return poses.finish(notes);
}

Trajectory read_tum(const TextFile& file, double unit_s, std::vector<std::string>& notes) {
  return read_lines(file, notes, [&](const TextLine& line) {
    require(line.fields.size() == 8, line.place(),
            ": expected 8 values (timestamp tx ty tz qx qy qz qw), got ", line.fields.size());
    return parse_tum_pose(line, unit_s);
  });
}

Trajectory read_euroc(const TextFile& file, std::vector<std::string>& notes) {
  return read_lines(file, notes, [](const TextLine& line) {
    require(line.fields.size() >= 8, line.place(),
            ": expected at least 8 values (timestamp px py pz qw qx qy qz), got ",
            line.fields.size());
    require(begins_as_euroc(line), line.place(),
            ": expected a stamp in whole nanoseconds and a comma, as EuRoC has them, got ",
            line.fields[0]);
    return parse_euroc_pose(line);
  });
}

Trajectory read_kitti(const TextFile& file, const FrameTimes* times,
                      std::vector<std::string>& notes) {
  std::size_t frame = 0;
  const auto next_timestamp = [&](const TextLine& line) {
    const std::size_t index = frame++;
    if (times == nullptr) {
      return kKittiInterval * static_cast<double>(index);
    }
    require(index < times->size(), line.place(), ": is pose ", index + 1,
            ", expected as many as the ", times->size(), " stamps of ", times->path().string());
    return times->at(index);
  };
  Trajectory trajectory = read_lines(file, notes, [&](const TextLine& line) {
    return StampedPose{next_timestamp(line), parse_kitti_pose(line)};
  });
  require(times == nullptr || frame == times->size(), file.path().string(), ": holds ", frame,
          " poses, expected as many as the ", times == nullptr ? 0 : times->size(), " stamps of ",
          times == nullptr ? "" : times->path().string());
  if (times == nullptr) {
    notes.push_back(concat(file.path().string(), ": KITTI's poses have no stamps and are taken as ",
                           kKittiInterval, " s apart; --times LIST gives them"));
  }
  return trajectory;
}

Trajectory read_as(TrajectoryFormat format, const TextFile& file, const FrameTimes* times,
                   std::vector<std::string>& notes) {
  switch (format) {
    case TrajectoryFormat::tum:
      return read_tum(file, 1, notes);
    case TrajectoryFormat::orb_slam:
      return read_tum(file, kNanosecond, notes);
    case TrajectoryFormat::euroc:
      return read_euroc(file, notes);
    case TrajectoryFormat::kitti:
      return read_kitti(file, times, notes);
    case TrajectoryFormat::colmap:
      return read_colmap_images(file, times, notes);
    case TrajectoryFormat::mcap:
    case TrajectoryFormat::bag:
      fail(file.path().string(), ": is no recording, expected ", to_string(format));
  }
  return {};
}

TrajectoryFormat format_of(const Recording& recording) {
  return recording.format() == RecordingFormat::mcap ? TrajectoryFormat::mcap
                                                     : TrajectoryFormat::bag;
}

TrajectoryFile read_recording(const RecordingName& name, const TrajectoryReading& reading) {
  const Recording recording(name.file);
  TrajectoryFile result{.format = format_of(recording), .notes = recording.notes()};
  require(!reading.format || *reading.format == result.format, name.file.string(), ": is a ",
          to_string(result.format), " recording, expected ",
          to_string(reading.format.value_or(result.format)));
  result.trajectory = read_recorded_trajectory(recording, name.topic, result.notes);
  return result;
}

}  // namespace

SE3 checked_pose(const std::string& place, const Eigen::Quaterniond& rotation,
                 const Eigen::Vector3d& position) {
  require_within_reach(place, position);
  require(is_nearly_unit(rotation.coeffs()), place,
          ": expected a quaternion of length 1, got length ", rotation.norm());
  return {rotation, position};
}

SE3 checked_pose(const std::string& place, const Eigen::Matrix<double, 3, 4>& rows) {
  const Eigen::Matrix3d R = rows.leftCols<3>();
  require_within_reach(place, rows.col(3));
  require((R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < kUnitTolerance &&
              R.determinant() > 0,
          place, ": expected a rotation in the first three columns");
  return {Eigen::Quaterniond(R), rows.col(3)};
}

TrajectoryFile read_trajectory_file(const std::filesystem::path& path,
                                    const TrajectoryReading& reading) {
  const RecordingName name = recording_name(path);
  if (recording_format(name.file)) {
    return read_recording(name, reading);
  }
  const TextFile file(path);
  TrajectoryFile result;
  result.format = reading.format ? *reading.format : recognise_trajectory(file);
  const std::optional<FrameTimes> times =
      reading.times.empty() ? std::nullopt : std::optional<FrameTimes>(reading.times);
  result.trajectory = read_as(result.format, file, times ? &*times : nullptr, result.notes);
  return result;
}

Trajectory read_trajectory(const std::filesystem::path& path) {
  return read_trajectory_file(path).trajectory;
}

Trajectory read_truth(const std::filesystem::path& path, TrajectoryFormat format,
                      std::vector<std::string>& notes) {
  return read_as(format, TextFile(path), nullptr, notes);
}

}  // namespace vo
