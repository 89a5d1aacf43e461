#include "vo/motion_files/redwood_log.h"

#include <Eigen/Core>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

constexpr Eigen::Index kRows = 4;

/// Returns the index of the frame that a line of three whole numbers begins.
std::size_t frame_of(const TextLine& line, const std::vector<double>& timestamps) {
  require(line.fields.size() == 3, line.place(), ": expected three whole numbers, got ",
          line.fields.size(), " values");
  const double frame = parse_number(line, 0);
  require(frame >= 0 && frame < static_cast<double>(timestamps.size()), line.place(),
          ": expected one of ", timestamps.size(), " frames, from 0, got ", line.fields[0]);
  return static_cast<std::size_t>(frame);
}

}  // namespace

Trajectory read_redwood_log(const std::filesystem::path& path,
                            const std::vector<double>& timestamps) {
  Trajectory trajectory;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  Eigen::Index row = kRows;  // of the matrix that is being read; beyond it, a pose begins
  std::size_t frame = 0;
  TextFile(path).for_each_line([&](const TextLine& line) {
    if (row == kRows) {
      frame = frame_of(line, timestamps);
      require(trajectory.empty() || timestamps[frame] > trajectory.back().timestamp, line.place(),
              ": expected a frame after the one before it, got ", line.fields[0]);
      row = 0;
      return;
    }
    require(line.fields.size() == 4, line.place(), ": expected a row of four numbers, got ",
            line.fields.size());
    for (std::size_t i = 0; i < 4; ++i) {
      matrix(row, static_cast<Eigen::Index>(i)) = parse_number(line, i);
    }
    if (++row == kRows) {
      trajectory.push_back(
          {timestamps[frame],
           checked_pose(line.place(), Eigen::Matrix<double, 3, 4>(matrix.topRows<3>()))});
    }
  });
  require(row == kRows, path.string(), ": ends within a pose's matrix");
  require(!trajectory.empty(), path.string(), ": holds no poses");
  return trajectory;
}

}  // namespace vo
