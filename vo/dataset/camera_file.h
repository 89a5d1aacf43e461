#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vo/geometry/camera.h"
#include "vo/geometry/camera_model.h"

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
RgbdCamera load_camera(const std::string& preset_or_path);

RgbdCamera read_camera(const std::filesystem::path& path);

/// Returns a camera that a file gave; throws Error naming the file unless it is a usable one.
const RgbdCamera& checked_camera(const RgbdCamera& camera, const std::filesystem::path& path);

/// Returns the camera of a sequence's folder: `given`, else that of its camera.toml, else
/// `otherwise`.
RgbdCamera camera_of_folder(const std::filesystem::path& folder,
                            const std::optional<RgbdCamera>& given, const RgbdCamera& otherwise);

/// Returns the text of a camera.toml; a read-out or depth noise that is unknown is left out.
std::string format_camera(const RgbdCameraModel& camera);

}  // namespace vo
