#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vo/geometry/camera.h"

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
/// Returns the text of a camera.toml; a read-out or depth noise that is unknown is left out.
std::string format_camera(const RgbdCamera& camera);

}  // namespace vo
