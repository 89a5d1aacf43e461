#include "vo/rigs/rig_file.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/rigs/rig_pose.h"
#include "vo/rigs/rig_projector.h"

namespace vo {
namespace {

constexpr const char* kSensor = "sensor.";

/// Throws Error unless a camera's name can be that of its folder beside the rig's own files.
void require_folder_name(const RigCamera& camera) {
  require(!camera.name.empty(), camera.place, ": [[camera]]: expected a name");
  require(is_plain_name(camera.name) && camera.name != "truth", describe(camera),
          ": expected a name of letters, digits, '-' and '_', other than truth");
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
  require(camera.scene_light >= 0 && camera.scene_light <= 1, describe(camera),
          ": scene_light: expected a share from 0 to 1, got ", format_real(camera.scene_light));
  require(camera.scene_light == 1 || camera.spectrum == Spectrum::infrared, describe(camera),
          ": scene_light: is for cameras with spectrum = \"infrared\"; others see all of it");
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
  result.camera = take_projection(record.values);
  PoseValues pose;
  std::vector<Field> fields;
  FieldCollector collect(fields, "");
  collect("name", result.name, "of the camera");
  visit_fields(collect, result.camera);
  collect("time_offset", result.time_offset, "s");
  collect("stereo", result.stereo, "name of the partner");
  collect("spectrum", result.spectrum, "the light that it sees");
  collect("scene_light", result.scene_light, "share of the scene's light in infrared");
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
  if (camera.spectrum != Spectrum::visible) {
    text += concat("spectrum = ", quoted_toml(to_string(camera.spectrum)), "\n");
    text +=
        format_toml(TomlValue{"scene_light", format_real(camera.scene_light), FieldType::real, ""});
  }
  for (TomlValue value : camera.sensor) {
    value.key = kSensor + value.key;
    text += format_toml(value);
  }
  return text;
}

/// Reads the projectors of a rig's file in a folder.
std::vector<RigProjector> read_projectors(const std::vector<TomlRecord>& records,
                                          const std::filesystem::path& folder) {
  constexpr std::size_t kMostProjectors = 16;
  if (records.size() > kMostProjectors) {
    fail(records[kMostProjectors].place, ": [[projector]]: expected at most ", kMostProjectors,
         " projectors, got ", records.size());
  }
  std::vector<RigProjector> projectors;
  for (const TomlRecord& record : records) {
    projectors.push_back(read_rig_projector(record, folder));
  }
  return projectors;
}

/// Throws Error unless each camera or projector has a name that no other one has.
template <typename Part>
void require_own_names(const std::vector<Part>& parts, const char* kind) {
  std::set<std::string> names;
  for (const Part& part : parts) {
    require(names.insert(part.name).second, describe(part),
            ": expected a name of its own, another ", kind, " has it");
  }
}

}  // namespace

bool is_rig(const std::filesystem::path& folder) {
  return std::filesystem::is_regular_file(folder / kRigFile);
}

Rig read_rig(const std::filesystem::path& path) {
  TomlRecords file = read_toml_records(path, {"camera", "projector"});
  std::vector<TomlRecord>& cameras = file.arrays["camera"];
  require(!cameras.empty(), path.string(), ": expected a table [[camera]] for each camera");
  Rig rig;
  rig.T_body_imu = read_imu_pose(path, file.others);
  for (TomlRecord& record : cameras) {
    rig.cameras.push_back(read_rig_camera(std::move(record)));
  }
  rig.projectors = read_projectors(file.arrays["projector"], path.parent_path());
  require_own_names(rig.cameras, "camera");
  require_own_names(rig.projectors, "projector");
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
  for (const RigProjector& projector : rig.projectors) {
    text += format_rig_projector(projector);
  }
  return text;
}

}  // namespace vo
