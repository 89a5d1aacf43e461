#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vo/geometry/camera.h"

namespace vo {

/// The cameras of public data sets, by name.
struct CameraPreset {
  std::string name;
  std::string help;  ///< origin of the figures, and what to know before using them
  RgbdCamera camera;
};

const std::vector<CameraPreset>& camera_presets();

/// A preset's name, or the path of a camera.toml. Throws Error naming the nearest preset.
RgbdCamera load_camera(const std::string& preset_or_path);

RgbdCamera read_camera(const std::filesystem::path& path);
std::string format_camera(const RgbdCamera& camera);

}  // namespace vo
