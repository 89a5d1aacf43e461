#include "vo/dataset/camera_file.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/text_files/toml_file.h"

namespace vo {
namespace {

RgbdCamera vga_camera(double fx, double fy, double cx, double cy, const Distortion& distortion = {},
                      double depth_units_per_m = 5000) {
  return {{640, 480, fx, fy, cx, cy, distortion}, depth_units_per_m};
}

/// Returns the value of a file's key `projection`, a pinhole without it, and takes it out.
CameraProjection projection_in(std::vector<TomlValue>& values) {
  CameraProjection projection = CameraProjection::pinhole;
  std::vector<Field> fields;
  FieldCollector collect(fields, "");
  collect("projection", projection, "how the image shows directions");
  const auto given =
      std::stable_partition(values.begin(), values.end(),
                            [](const TomlValue& value) { return value.key != "projection"; });
  assign_fields({given, values.end()}, fields);
  values.erase(given, values.end());
  return projection;
}

bool is_of_pinhole(const TomlValue& value) {
  constexpr std::array<std::string_view, 4> kIntrinsics{"fx", "fy", "cx", "cy"};
  return std::find(kIntrinsics.begin(), kIntrinsics.end(), value.key) != kIntrinsics.end() ||
         value.key.starts_with("distortion.");
}

void require_valid(const RgbdCameraModel& camera, const std::filesystem::path& path) {
  try {
    camera.validate();
  } catch (const Error& error) {
    fail(path.string(), ": ", error.what());
  }
}

/// Returns a camera that is a pinhole; throws Error, which begins with `place`, if it is none.
RgbdCamera require_pinhole(const RgbdCameraModel& camera, const std::string& place) {
  return {camera.model.pinhole_for(place), camera.depth_units_per_m, camera.readout,
          camera.depth_noise};
}

}  // namespace

const std::vector<CameraPreset>& camera_presets() {
  static const std::vector<CameraPreset> presets = {
      {"tum-fr1", "TUM RGB-D, freiburg1: calibrated colour camera with lens distortion",
       vga_camera(517.306408, 516.469215, 318.643040, 255.313989,
                  {0.262383, -0.953104, -0.005358, 0.002628, 1.163314})},
      {"tum-fr2", "TUM RGB-D, freiburg2: calibrated colour camera with lens distortion",
       vga_camera(520.908620, 521.007327, 325.141442, 249.701764,
                  {0.231222, -0.784899, -0.003257, -0.000105, 0.917205})},
      {"tum-fr3", "TUM RGB-D, freiburg3: images are undistorted already",
       vga_camera(535.4, 539.2, 320.1, 247.6)},
      {"tum-default", "the factory model by which all TUM depth was registered to colour",
       vga_camera(525.0, 525.0, 319.5, 239.5)},
      {"icl-nuim",
       "ICL-NUIM as rendered: fy is negative because POV-Ray's camera has y up; its poses are in "
       "that frame, so the sign must stay",
       vga_camera(481.2, -480.0, 319.5, 239.5)},
      {"7-scenes", "Microsoft 7-Scenes: depth in millimetres, 65535 is no measurement",
       vga_camera(585.0, 585.0, 320.0, 240.0, {}, 1000)},
  };
  return presets;
}

RgbdCameraModel load_camera_model(const std::string& preset_or_path) {
  std::vector<std::string> names;
  std::string list;
  for (const CameraPreset& preset : camera_presets()) {
    if (preset.name == preset_or_path) {
      return preset.camera;
    }
    names.push_back(preset.name);
    list += (list.empty() ? "" : ", ") + preset.name;
  }
  if (std::filesystem::exists(preset_or_path)) {
    return read_camera_model(preset_or_path);
  }
  const std::string nearest = nearest_key(preset_or_path, names);
  fail("camera '", preset_or_path, "': neither a file nor a preset (", list, ")",
       nearest.empty() ? "" : "; the nearest preset is ", nearest);
}

RgbdCamera load_camera(const std::string& preset_or_path) {
  return require_pinhole(load_camera_model(preset_or_path), preset_or_path);
}

RgbdCameraModel take_projection(std::vector<TomlValue>& values) {
  RgbdCameraModel camera;
  if (projection_in(values) == CameraProjection::pinhole) {
    PinholeCamera pinhole;
    pinhole.cx = std::numeric_limits<double>::quiet_NaN();  // a file must give the principal point
    pinhole.cy = pinhole.cx;
    camera.model = pinhole;
    return camera;
  }
  const auto odd = std::find_if(values.begin(), values.end(), is_of_pinhole);
  if (odd != values.end()) {
    fail(odd->place, ": ", odd->key,
         ": expected none beside projection = \"equirectangular\", which has width and height "
         "alone");
  }
  camera.model = EquirectangularCamera();
  return camera;
}

RgbdCameraModel read_camera_model(const std::filesystem::path& path) {
  std::vector<TomlValue> values = read_toml(path);
  RgbdCameraModel camera = take_projection(values);
  std::vector<Field> fields = fields_of(camera);
  assign_fields(values, fields);
  require_valid(camera, path);
  return camera;
}

RgbdCamera read_camera(const std::filesystem::path& path) {
  return require_pinhole(read_camera_model(path), path.string());
}

const RgbdCamera& checked_camera(const RgbdCamera& camera, const std::filesystem::path& path) {
  require_valid(camera, path);
  return camera;
}

const RgbdCamera& camera_for_folder(const std::filesystem::path& folder, const RgbdCamera& given) {
  const std::filesystem::path file = folder / "camera.toml";
  if (std::filesystem::exists(file)) {
    std::vector<TomlValue> values = read_toml(file);
    take_projection(values).model.pinhole_for(file.string());
  }
  return given;
}

RgbdCamera camera_of_folder(const std::filesystem::path& folder,
                            const std::optional<RgbdCamera>& given, const RgbdCamera& otherwise) {
  if (given) {
    return camera_for_folder(folder, *given);
  }
  const std::filesystem::path file = folder / "camera.toml";
  return std::filesystem::exists(file) ? read_camera(file) : otherwise;
}

std::string format_camera(const RgbdCameraModel& camera) {
  RgbdCameraModel copy = camera;
  std::vector<Field> fields = fields_of(copy);
  if (!camera.readout.is_rolling()) {
    std::erase_if(fields, [](const Field& field) { return field.key.starts_with("readout"); });
  }
  if (!camera.depth_noise.is_known()) {
    std::erase_if(fields, [](const Field& field) { return field.key.starts_with("depth_noise"); });
  }
  return format_projection(camera.model) + format_toml(fields);
}

std::string format_projection(const CameraModel& camera, const std::string& prefix) {
  if (camera.projection() == CameraProjection::pinhole) {
    return "";
  }
  return concat(prefix, "projection = ", quoted_toml(to_string(camera.projection())),
                "  # depth is the distance along the ray\n");
}

}  // namespace vo
