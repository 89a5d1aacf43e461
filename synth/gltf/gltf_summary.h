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

/// A summary of a glTF file. The counts are those of the Khronos validator: each primitive counts
/// once, however many nodes show it, points and lines included.
struct GltfSummary {
  std::size_t draw_calls = 0;  ///< number of primitives
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  /// m, world, of all positions of the scene's meshes with their nodes' transforms, neither skinned
  /// nor morphed; points and lines included.
  Eigen::AlignedBox3d bounds;
  Eigen::AlignedBox3d bounds_at_rest;  ///< m, world, of what is rendered if no animation plays
  std::vector<std::string> scenes, materials;
  std::vector<std::string> extensions_used, extensions_required;
  std::vector<AnimationSummary> animations;
  std::size_t nodes = 0;
  std::size_t textures = 0;
  std::size_t images = 0;
  std::size_t skins = 0;
  Scene scene;  ///< what load_gltf returns
  std::size_t moving_instances = 0;
  std::size_t sharing_instances = 0;  ///< instances with a mesh that is kept once for all of them
  std::size_t shown_triangles = 0;    ///< number of triangles that the instances show
  Notes notes;
};

/// Loads a glTF file and summarises its content. Throws what load_gltf does.
GltfSummary summarize_gltf(const std::filesystem::path& path, const GltfOptions& options);

}  // namespace synth
