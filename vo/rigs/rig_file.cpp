#include "vo/rigs/rig_file.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/motion_files/trajectory_file.h"

namespace vo {
namespace {

constexpr const char* kSensor = "sensor.";

/// A pose as a rig's file has it.
struct PoseValues {
  std::vector<double> matrix;  ///< four rows
  std::vector<double> position;
  std::vector<double> orientation;  ///< x, y, z, w
};

/// Returns a field that takes `count` numbers into a vector.
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

/// Returns the pose of a matrix of four rows. Throws Error, which begins with `place`, if it is
/// none.
SE3 pose_of_matrix(const std::string& place, const std::vector<double>& values) {
  const Eigen::Matrix4d T =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data());
  require(T.row(3) == Eigen::RowVector4d(0, 0, 0, 1), place,
          ": expected 0, 0, 0, 1 as the fourth row");
  return checked_pose(place, Eigen::Matrix<double, 3, 4>(T.topRows<3>()));
}

/// Returns the pose that a file gives. Throws Error, which begins with `place`, if it is none.
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

bool is_in_folder_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_';
}

/// Throws Error unless a camera's name can be that of its folder beside the rig's own files.
void require_folder_name(const RigCamera& camera) {
  require(!camera.name.empty(), camera.place, ": [[camera]]: expected a name");
  require(std::all_of(camera.name.begin(), camera.name.end(), is_in_folder_name) &&
              camera.name != "truth",
          describe(camera), ": expected a name of letters, digits, '-' and '_', other than truth");
}

void validate(const RigCamera& camera) {
  constexpr double kMaxOffset = 1;  // s
  try {
    camera.camera.validate();
  } catch (const Error& error) {
    fail(describe(camera), ": ", error.what());
  }
  require(std::abs(camera.time_offset) <= kMaxOffset, describe(camera),
          ": time_offset: expected at most ", kMaxOffset, " s, got ",
          format_real(camera.time_offset));
}

/// Moves the values of the sensor out of those of a camera, their keys without `sensor.`.
std::vector<TomlValue> take_sensor(std::vector<TomlValue>& values) {
  const auto first =
      std::stable_partition(values.begin(), values.end(),
                            [](const TomlValue& value) { return !value.key.starts_with(kSensor); });
  std::vector<TomlValue> sensor(std::make_move_iterator(first),
                                std::make_move_iterator(values.end()));
  values.erase(first, values.end());
  for (TomlValue& value : sensor) {
    value.key.erase(0, std::string_view(kSensor).size());
  }
  return sensor;
}

RigCamera read_rig_camera(TomlRecord record) {
  RigCamera result;
  result.place = record.place;
  result.sensor = take_sensor(record.values);
  result.camera.pinhole.cx = std::numeric_limits<double>::quiet_NaN();  // a file must give it
  result.camera.pinhole.cy = result.camera.pinhole.cx;
  PoseValues pose;
  std::vector<Field> fields;
  FieldCollector collect(fields, "");
  collect("name", result.name, "of the camera");
  visit_fields(collect, result.camera);
  collect("time_offset", result.time_offset, "s");
  collect("stereo", result.stereo, "name of the partner");
  add_pose_fields("", "T_body_camera", pose, fields);
  assign_fields(record.values, fields);
  require_folder_name(result);
  result.T_body_camera = pose_of(describe(result), "T_body_camera", pose);
  validate(result);
  return result;
}

SE3 read_imu_pose(const std::filesystem::path& path, const std::vector<TomlValue>& values) {
  PoseValues pose;
  std::vector<Field> fields;
  add_pose_fields("imu.", "T_body_imu", pose, fields);
  assign_fields(values, fields);
  return pose_of(path.string() + ": imu", "T_body_imu", pose);
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

std::string format_rig_camera(const RigCamera& camera) {
  std::string text =
      concat("\n[[camera]]\nname = ", quoted_toml(camera.name), "\n",
             format_pose("T_body_camera", camera.T_body_camera), format_camera(camera.camera));
  if (camera.time_offset != 0) {
    text +=
        format_toml(TomlValue{"time_offset", format_real(camera.time_offset), FieldType::real, ""});
  }
  if (!camera.stereo.empty()) {
    text += concat("stereo = ", quoted_toml(camera.stereo), "\n");
  }
  for (TomlValue value : camera.sensor) {
    value.key = kSensor + value.key;
    text += format_toml(value);
  }
  return text;
}

}  // namespace

bool is_rig(const std::filesystem::path& folder) {
  return std::filesystem::is_regular_file(folder / kRigFile);
}

Rig read_rig(const std::filesystem::path& path) {
  TomlRecords file = read_toml_records(path, "camera");
  require(!file.records.empty(), path.string(), ": expected a table [[camera]] for each camera");
  Rig rig;
  rig.T_body_imu = read_imu_pose(path, file.others);
  std::set<std::string> names;
  for (TomlRecord& record : file.records) {
    rig.cameras.push_back(read_rig_camera(std::move(record)));
    const RigCamera& camera = rig.cameras.back();
    require(names.insert(camera.name).second, describe(camera),
            ": expected a name of its own, another camera has it");
  }
  for (const RigCamera& camera : rig.cameras) {
    if (!camera.stereo.empty()) {
      stereo_partner(rig, camera);
    }
  }
  return rig;
}

std::string format_rig(const Rig& rig) {
  std::string text =
      "# Poses take from the camera's or the IMU's axes to the body's; cameras have x right, y "
      "down, z forward.\n[imu]\n" +
      format_pose("T_body_imu", rig.T_body_imu);
  for (const RigCamera& camera : rig.cameras) {
    text += format_rig_camera(camera);
  }
  return text;
}

}  // namespace vo
