#include "vo/motion_files/pose_matrix.h"

#include <limits>

#include "vo/core/error.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

/// Returns a value of a matrix; NaN for what is no finite number but means so.
double matrix_value(const TextLine& line, std::size_t field) {
  for (const std::string_view lost : {"inf", "-inf", "+inf", "nan", "-nan", "NaN", "Inf", "-Inf"}) {
    if (line.fields[field] == lost) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }
  return parse_number(line, field);
}

}  // namespace

Eigen::Matrix4d read_matrix(const std::filesystem::path& path) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  Eigen::Index row = 0;
  TextFile(path).for_each_line([&](const TextLine& line) {
    require(line.fields.size() == 4 && row < 4, line.place(),
            ": expected four rows of four numbers, got ", line.fields.size(), " in row ", row + 1);
    for (std::size_t i = 0; i < 4; ++i) {
      matrix(row, static_cast<Eigen::Index>(i)) = matrix_value(line, i);
    }
    ++row;
  });
  require(row >= 3, path.string(), ": expected four rows of four numbers, got ", row, " rows");
  return matrix;
}

std::optional<SE3> read_pose_matrix(const std::filesystem::path& path) {
  const Eigen::Matrix4d matrix = read_matrix(path);
  return matrix.allFinite() ? std::optional(checked_pose(
                                  path.string(), Eigen::Matrix<double, 3, 4>(matrix.topRows<3>())))
                            : std::nullopt;
}

}  // namespace vo
