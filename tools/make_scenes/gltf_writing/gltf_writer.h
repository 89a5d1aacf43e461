#pragma once

#include <filesystem>

#include "tools/make_scenes/model/model.h"

namespace scenes {

/// Writes `folder`/NAME.gltf, NAME.bin and a PNG per image, where NAME is the model's; replaces old
/// ones. Only the materials and images that the model shows are written. Creates the folder. Throws
/// vo::Error on failure.
void write_gltf(const Model& model, const std::filesystem::path& folder);

}  // namespace scenes
