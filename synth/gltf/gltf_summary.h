#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "synth/gltf/gltf.h"

namespace synth {

struct AnimationSummary {
  std::string name;
  double duration = 0;  ///< s
  std::size_t channels = 0;
};

/// What a file holds. The counts are those of the Khronos validator: each primitive of the file
/// once, however many nodes show it, points and lines included.
struct GltfSummary {
  std::size_t draw_calls = 0;  ///< primitives
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  /// m, world: all positions of the scene's meshes where their nodes put them, neither skinned nor
  /// morphed; points and lines included.
  Eigen::AlignedBox3d bounds;
  Eigen::AlignedBox3d bounds_at_rest;  ///< m, world: what is rendered while no animation plays
  std::vector<std::string> scenes, materials;
  std::vector<std::string> extensions_used, extensions_required;
  std::vector<AnimationSummary> animations;
  std::size_t nodes = 0;
  std::size_t textures = 0;
  std::size_t images = 0;
  std::size_t skins = 0;
  Scene scene;  ///< as load_gltf reads it
  Notes notes;
};

/// Loads the file and sums up what is in it. Throws what load_gltf does.
GltfSummary summarize_gltf(const std::filesystem::path& path, const GltfOptions& options);

}  // namespace synth
