#pragma once

#include <filesystem>
#include <vector>

#include "tools/make_room/finish.h"
#include "tools/make_room/model.h"

namespace room {

/// Writes `folder`/room.gltf, room.bin and a PNG per image, replacing them. The folder is made.
/// Throws vo::Error if it cannot.
void write_gltf(const Model& model, const std::vector<Material>& materials,
                const std::vector<NamedImage>& images, const std::filesystem::path& folder);

}  // namespace room
