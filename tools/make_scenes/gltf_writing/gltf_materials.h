#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "tools/make_scenes/painting/finish.h"

namespace scenes {

/// Adds the materials, in order, and their textures, samplers and images to a glTF document.
void add_materials(nlohmann::ordered_json& gltf, const std::vector<Material>& materials,
                   const std::vector<NamedImage>& images);

}  // namespace scenes
