#pragma once

#include <map>
#include <utility>
#include <vector>

#include "synth/gltf/gltf.h"
#include "synth/gltf_model/gltf_reading.h"
#include "synth/scene/scene.h"

namespace synth {

/// Reads a model's materials, with their textures and images, into a scene as they are asked for.
class MaterialReader {
 public:
  /// `reading` and `scene` must outlive the reader. Textures that the options do not need are left
  /// out, with a note, where their image's file does not exist; lengths are times their scale.
  MaterialReader(GltfReading& reading, Scene& scene, const GltfOptions& options);

  /// Returns the scene's index of a glTF material, kNone for kNone. Throws vo::Error if an image
  /// that the material needs cannot be decoded.
  int material(int gltf_index);

  /// Returns the glTF index of each of the scene's materials.
  std::vector<int> sources() const;

 private:
  Material read_material(const tinygltf::Material& source);
  void read_surface(const tinygltf::Material& source, Material& material);
  void read_maps(const tinygltf::Material& source, Material& material);
  template <typename TextureInfo>
  TextureSlot slot(const TextureInfo& info, TexelEncoding encoding, NeededTextures use);
  int texture(int gltf_index, TexelEncoding encoding, NeededTextures use);
  bool is_left_out(int gltf_image, NeededTextures use);
  int image(int gltf_index, TexelEncoding encoding);

  /// The scene's index of each texture or image read so far, by glTF index and encoding.
  using Read = std::map<std::pair<int, TexelEncoding>, int>;

  GltfReading& reading_;
  const GltfModel& model_;
  Scene& scene_;
  NeededTextures needed_;
  double scale_;
  MemoryBudget image_budget_;
  std::vector<int> materials_;  ///< scene index by glTF index; kNone until it is read
  Read textures_, images_;
};

}  // namespace synth
