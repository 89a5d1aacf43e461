#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synth/scene.h"

namespace synth {

/// What a file holds that the Scene leaves out, one sentence each.
using Notes = std::vector<std::string>;

/// Reads .gltf or .glb (its default scene). Throws vo::Error naming the file, the element and what
/// was expected; nothing outside the file's own folder is opened. `notes`, if given, receives what
/// was skipped.
Scene load_gltf(const std::filesystem::path& path, Notes* notes = nullptr);

}  // namespace synth
