#pragma once

#include <map>
#include <utility>
#include <vector>

#include "synth/gltf_model/gltf_reading.h"
#include "synth/scene/scene.h"

namespace synth {

/// Puts those materials, textures and images of a model into a scene that are asked for.
class MaterialReader {
 public:
  /// Both must outlive the reader.
  MaterialReader(GltfReading& reading, Scene& scene);

  /// The scene's index of a glTF material; kNone stays kNone. Throws vo::Error if an image that
  /// it needs cannot be decoded.
  int material(int gltf_index);

 private:
  Material read_material(const tinygltf::Material& source);
  void read_surface(const tinygltf::PbrMetallicRoughness& source, Material& material);
  void read_maps(const tinygltf::Material& source, Material& material);
  template <typename TextureInfo>
  TextureSlot slot(const TextureInfo& info, TexelEncoding encoding);
  int texture(int gltf_index, TexelEncoding encoding);
  int image(int gltf_index, TexelEncoding encoding);

  /// What was read already: the scene's index by glTF's and by what its channels mean.
  using Read = std::map<std::pair<int, TexelEncoding>, int>;

  GltfReading& reading_;
  const GltfModel& model_;
  Scene& scene_;
  MemoryBudget image_budget_;
  std::vector<int> materials_;  ///< scene indices, kNone where not read yet
  Read textures_, images_;
};

}  // namespace synth
