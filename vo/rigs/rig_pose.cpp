#include "vo/rigs/rig_pose.h"

#include "vo/core/error.h"
#include "vo/motion_files/trajectory_file.h"

namespace vo {
namespace {

/// Returns the pose of a matrix of four rows. Throws Error, which begins with `place`, if it is
/// none.
SE3 pose_of_matrix(const std::string& place, const std::vector<double>& values) {
  const Eigen::Matrix4d T =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data());
  require(T.row(3) == Eigen::RowVector4d(0, 0, 0, 1), place,
          ": expected 0, 0, 0, 1 as the fourth row");
  return checked_pose(place, Eigen::Matrix<double, 3, 4>(T.topRows<3>()));
}

}  // namespace

Field numbers_field(const std::string& key, const char* help, std::size_t count,
                    std::vector<double>& values) {
  return {key, help, FieldType::reals, [] { return std::string(); },
          [&values, count](std::string_view text) { values = parse_reals(text, count); }};
}

void add_pose_fields(const std::string& prefix, const std::string& matrix, PoseValues& pose,
                     std::vector<Field>& fields) {
  fields.push_back(numbers_field(prefix + matrix, "four rows of a matrix", 16, pose.matrix));
  fields.push_back(numbers_field(prefix + "position", "in the body, m", 3, pose.position));
  fields.push_back(
      numbers_field(prefix + "orientation", "quaternion x, y, z, w", 4, pose.orientation));
}

SE3 pose_of(const std::string& place, const std::string& matrix, const PoseValues& values) {
  const bool has_parts = !values.position.empty() || !values.orientation.empty();
  require(values.matrix.empty() || !has_parts, place, ": expected ", matrix,
          " or position and orientation, not both");
  if (!values.matrix.empty()) {
    return pose_of_matrix(concat(place, ": ", matrix), values.matrix);
  }
  const std::vector<double> p = values.position.empty() ? std::vector<double>(3) : values.position;
  const std::vector<double> q =
      values.orientation.empty() ? std::vector<double>{0, 0, 0, 1} : values.orientation;
  return checked_pose(place, Eigen::Quaterniond(q[3], q[0], q[1], q[2]),
                      Eigen::Vector3d(p[0], p[1], p[2]));
}

std::string format_pose(const std::string& key, const SE3& T) {
  const Eigen::Matrix3d R = T.rotation_matrix();
  std::string text = key + " = [";
  for (int row = 0; row < 3; ++row) {
    text += concat("\n  [", format_real(R(row, 0)), ", ", format_real(R(row, 1)), ", ",
                   format_real(R(row, 2)), ", ", format_real(T.translation()[row]), "],");
  }
  return text + "\n  [0, 0, 0, 1],\n]\n";
}

}  // namespace vo
