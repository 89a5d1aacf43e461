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

/// The most bytes that each file, all geometry and all images of a scene may have: 1 GiB.
inline constexpr std::size_t kMostGltfBytes = std::size_t{1} << 30U;

/// What a .gltf or .glb file holds. Only the JSON's syntax has been checked.
// NOLINTNEXTLINE(bugprone-exception-escape): moving an nlohmann::json does not throw.
struct GltfFile {
  std::filesystem::path path;
  nlohmann::json json;
  bool is_glb = false;
  Bytes binary;  ///< the BIN chunk of a .glb
};

/// Tells .gltf and .glb apart by their content. Throws vo::Error.
GltfFile read_gltf_file(const std::filesystem::path& path);
GltfFile parse_gltf_file(std::span<const std::uint8_t> content, const std::filesystem::path& path);

/// The first `size` bytes of the file; throws vo::Error if it has fewer. `place` is the element
/// that refers to the file, or empty.
Bytes read_file(const std::filesystem::path& path, std::size_t size, const std::string& place);

/// The size of a regular file in bytes; throws vo::Error if there is none.
std::size_t file_size(const std::filesystem::path& path, const std::string& place);

}  // namespace synth
