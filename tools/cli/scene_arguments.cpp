#include "tools/cli/scene_arguments.h"

#include <utility>
#include <vector>

#include "tools/cli/options.h"
#include "tools/cli/trajectory_arguments.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/motion_files/trajectory_format.h"

namespace tools {
namespace {

/// Returns the path's fields except those that have an option of another name.
std::vector<vo::Field> path_fields(synth::PathOptions& path) {
  std::vector<vo::Field> fields;
  for (const vo::Field& field : vo::fields_of(path)) {
    if (field.key != "kind" && !field.key.starts_with("file")) {
      fields.push_back(field);
    }
  }
  return fields;
}

vo::RgbdCamera camera_of_options(const CameraArguments& arguments) {
  const auto [width, height] = parse_size(arguments.size);
  if (arguments.intrinsics.empty()) {
    return {vo::PinholeCamera::from_horizontal_fov(width, height, arguments.fov_deg)};
  }
  try {
    const std::vector<double> k = vo::parse_reals(arguments.intrinsics, 4);
    return {{width, height, k[0], k[1], k[2], k[3]}};
  } catch (const vo::Error& error) {
    vo::fail_as(vo::ErrorKind::usage, "--intrinsics: ", error.what());
  }
}

}  // namespace

void add_scene_options(CLI::App& command, synth::GltfOptions& options) {
  std::vector<vo::Field> fields = vo::fields_of(options);
  for (vo::Field& field : fields) {
    field.key = field.key == "scale" ? "scene_scale" : field.key;
  }
  add_field_options(command, fields, "Scene");
}

void add_actor_option(CLI::App& command, std::string& file) {
  command
      .add_option(
          "--actor", file,
          "FILE.toml with tables [[actor]], what goes through the scene: file, path, speed, ...")
      ->group("Scene");
}

void add_camera_options(CLI::App& command, CameraArguments& arguments) {
  command.add_option("--size", arguments.size, "WIDTHxHEIGHT, px [640x480]")->group("Camera");
  command.add_option("--intrinsics", arguments.intrinsics, "fx,fy,cx,cy, px")->group("Camera");
  command.add_option("--fov", arguments.fov_deg, "horizontal, deg, without --intrinsics [60]")
      ->group("Camera");
  command.add_option("--camera", arguments.camera, "preset or FILE.toml, instead of these")
      ->group("Camera");
}

vo::RgbdCameraModel chosen_camera(const CameraArguments& arguments) {
  if (!arguments.camera.empty()) {
    return vo::load_camera_model(arguments.camera);
  }
  vo::RgbdCameraModel camera;
  check_usage([&] { camera = camera_of_options(arguments); });
  return camera;
}

void add_camera_option(CLI::App& command, std::string& preset_or_file) {
  command.add_option("--camera", preset_or_file,
                     "preset or FILE.toml; otherwise the sequence's camera.toml");
}

std::optional<vo::RgbdCamera> given_camera(const std::string& preset_or_file) {
  return preset_or_file.empty() ? std::optional<vo::RgbdCamera>() : vo::load_camera(preset_or_file);
}

void add_path_options(CLI::App& command, PathArguments& arguments) {
  command
      .add_option("--trajectory", arguments.options.file,
                  "trajectory in any format that is read: one frame per pose without --path")
      ->group("Path");
  command
      .add_option("--trajectory-format", arguments.options.file_format,
                  "its format, where it is not recognised: " + trajectory_formats())
      ->check(is_name_of<vo::TrajectoryFormat>())
      ->group("Path");
  command
      .add_option("--trajectory-times", arguments.options.file_times,
                  "list of the stamps of a trajectory without (KITTI, COLMAP)")
      ->group("Path");
  command.add_option("--path", arguments.kind, "how the camera moves")
      ->check(is_name_of<synth::PathKind>())
      ->group("Path");
  add_field_options(command, path_fields(arguments.options), "Path");
}

synth::PathOptions chosen_path(const PathArguments& arguments) {
  synth::PathOptions path = arguments.options;
  if (!arguments.kind.empty()) {
    path.kind = vo::parse_enum<synth::PathKind>(arguments.kind);
  } else if (!path.file.empty()) {
    path.kind = synth::PathKind::trajectory;
  } else {
    vo::fail_as(vo::ErrorKind::usage, "expected --trajectory POSES.txt or --path KIND");
  }
  check_usage([&] { path.validate(); });
  return path;
}

}  // namespace tools
