#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "synth/scene/scene.h"
#include "tests/support/temp_folder.h"

namespace synth {

/// A glTF document under construction, with the bytes of its one buffer.
struct GltfDocument {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::string bytes;

  /// Appends the values, aligned, with a view and an accessor of `type`; returns its index.
  template <typename T>
  std::size_t add_accessor(const std::string& type, int component_type, std::size_t count,
                           const std::vector<T>& values) {
    json["accessors"].push_back({{"bufferView", add_view(values)},
                                 {"type", type},
                                 {"componentType", component_type},
                                 {"count", count}});
    return json["accessors"].size() - 1;
  }

  template <typename T>
  std::size_t add_view(const std::vector<T>& values) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t size = values.size() * sizeof(T);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
    bytes.append(reinterpret_cast<const char*>(values.data()), size);
    return json["bufferViews"].size() - 1;
  }

  /// The first primitive of the first mesh.
  nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

  /// Writes scene.gltf, and scene.bin unless the document names buffers of its own.
  std::filesystem::path write(const support::TempFolder& folder) const;

  /// The same as one file.
  std::string glb() const;
};

inline constexpr int kUnsignedByte = 5121;
inline constexpr int kShort = 5122;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kFloat = 5126;

inline std::filesystem::path GltfDocument::write(const support::TempFolder& folder) const {
  nlohmann::json complete = json;
  if (!json.contains("buffers") && !bytes.empty()) {
    complete["buffers"] = {{{"uri", "scene.bin"}, {"byteLength", bytes.size()}}};
    folder.write("scene.bin", bytes);
  }
  return folder.write("scene.gltf", complete.dump());
}

inline std::string GltfDocument::glb() const {
  const auto uint32 = [](std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&number), sizeof(number));
  };
  nlohmann::json complete = json;
  complete["buffers"] = {{{"byteLength", bytes.size()}}};
  std::string text = complete.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string binary = bytes;
  binary.resize((binary.size() + 3) / 4 * 4);
  const std::size_t length = 12 + 8 + text.size() + 8 + binary.size();
  return "glTF" + uint32(2) + uint32(length) + uint32(text.size()) + "JSON" + text +
         uint32(binary.size()) + std::string("BIN\0", 4) + binary;
}

/// A node with a mesh of one triangle: (0, 0, 0), (1, 0, 0), (0, 1, 0), in m.
inline GltfDocument triangle_document() {
  GltfDocument document;
  const std::size_t position =
      document.add_accessor<float>("VEC3", kFloat, 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::size_t indices =
      document.add_accessor<std::uint16_t>("SCALAR", kUnsignedShort, 3, {0, 1, 2});
  document.json["meshes"] = {
      {{"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", indices}}}}}};
  document.json["nodes"] = {{{"mesh", 0}}};
  document.json["scenes"] = {{{"nodes", {0}}}};
  return document;
}

/// The corners of all triangles of all instances, in the world, m.
inline std::vector<Eigen::Vector3d> world_corners(const Scene& scene) {
  std::vector<Eigen::Vector3d> corners;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes.at(static_cast<std::size_t>(instance.mesh));
    for (const std::array<int, 3>& triangle : mesh.triangles) {
      for (const int vertex : triangle) {
        const Eigen::Vector3f& p_mesh = mesh.positions.at(static_cast<std::size_t>(vertex));
        corners.push_back(instance.T_world_mesh * p_mesh.cast<double>());
      }
    }
  }
  return corners;
}

}  // namespace synth
