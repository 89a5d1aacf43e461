#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vo/geometry/camera.h"
#include "vo/geometry/camera_model.h"
#include "vo/text_files/toml_file.h"

namespace vo {

/// Camera of a public data set, known by name.
struct CameraPreset {
  std::string name;
  std::string help;  ///< origin of the figures, and what to know before using them
  RgbdCamera camera;
};

const std::vector<CameraPreset>& camera_presets();

/// Returns the preset of this name, or reads the camera.toml at this path. Throws Error naming the
/// nearest preset if it is neither.
RgbdCameraModel load_camera_model(const std::string& preset_or_path);

/// Does as `load_camera_model`, and throws Error naming the file of a camera that is no pinhole.
RgbdCamera load_camera(const std::string& preset_or_path);

/// Reads a camera.toml, whose `projection` is a pinhole where it says nothing else.
RgbdCameraModel read_camera_model(const std::filesystem::path& path);

/// Reads the camera.toml of what is tracked or converted. Throws Error naming file and projection
/// of a camera that is no pinhole.
RgbdCamera read_camera(const std::filesystem::path& path);

/// Returns a camera of the projection that the values of a file name, without values of its own,
/// and takes that value out of the list. Throws Error with file:line for a projection that does not
/// exist, and for values that an equirectangular camera does not have.
RgbdCameraModel take_projection(std::vector<TomlValue>& values);

/// Returns a camera that a file gave; throws Error naming the file unless it is a usable one.
const RgbdCamera& checked_camera(const RgbdCamera& camera, const std::filesystem::path& path);

/// Returns a camera that was given for the images of a folder, whatever intrinsics its camera.toml
/// has. Throws Error naming that file and its projection if they are no pinhole's.
const RgbdCamera& camera_for_folder(const std::filesystem::path& folder, const RgbdCamera& given);

/// Returns the camera of a sequence's folder: `given`, else that of its camera.toml, else
/// `otherwise`.
RgbdCamera camera_of_folder(const std::filesystem::path& folder,
                            const std::optional<RgbdCamera>& given, const RgbdCamera& otherwise);

/// Returns the text of a camera.toml; a pinhole's projection, and a read-out or depth noise that is
/// unknown, are left out.
std::string format_camera(const RgbdCameraModel& camera);

/// Returns a line that names a camera's projection and what its depth is, its key prefixed as
/// given; nothing for a pinhole.
std::string format_projection(const CameraModel& camera, const std::string& prefix = "");

}  // namespace vo
