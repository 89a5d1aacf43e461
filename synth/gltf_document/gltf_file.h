#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace synth {

using Bytes = std::vector<std::uint8_t>;

/// The limit in bytes, 1 GiB, of each file, of all geometry and of all images of a scene.
inline constexpr std::size_t kMostGltfBytes = std::size_t{1} << 30U;

/// The content of a .gltf or .glb file. Only its JSON's syntax has been checked.
// NOLINTNEXTLINE(bugprone-exception-escape): moving an nlohmann::json does not throw.
struct GltfFile {
  std::filesystem::path path;
  nlohmann::json json;
  bool is_glb = false;
  Bytes binary;  ///< BIN chunk of a .glb, else empty
};

/// Reads a .gltf or .glb file, told apart by content. Throws vo::Error if it cannot be parsed.
GltfFile read_gltf_file(const std::filesystem::path& path);
/// Parses the content of a .gltf or .glb file, which `path` names. Throws vo::Error on bad syntax.
GltfFile parse_gltf_file(std::span<const std::uint8_t> content, const std::filesystem::path& path);

/// Returns the first `size` bytes of a file. Throws vo::Error if it has fewer or `size` is over
/// kMostGltfBytes. `place` names the element that refers to the file, or is empty.
Bytes read_file(const std::filesystem::path& path, std::size_t size, const std::string& place);

/// Returns a file's size in bytes. Throws vo::Error if there is no such regular file. `place` names
/// the element that refers to the file, or is empty.
std::size_t file_size(const std::filesystem::path& path, const std::string& place);

}  // namespace synth
