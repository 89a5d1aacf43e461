#pragma once

#include <filesystem>
#include <string>

namespace tools {

/// Returns a hash of a glTF file and of every file that it names, which is much faster than loading
/// the scene. Throws vo::Error naming a file that is missing.
std::string scene_files_hash(const std::filesystem::path& gltf);

}  // namespace tools
