#pragma once

#include <filesystem>

#include "tools/make_scenes/model/model.h"

namespace scenes {

/// Writes `folder`/NAME.gltf, NAME.bin and a PNG per image, replacing them; NAME is the model's.
/// Only the materials and images that the model shows are written. The folder is made. Throws
/// vo::Error if it cannot.
void write_gltf(const Model& model, const std::filesystem::path& folder);

}  // namespace scenes
