#pragma once

#include <map>
#include <utility>

#include <tiny_gltf.h>

#include "synth/gltf_materials/needed_textures.h"
#include "synth/gltf_model/gltf_reading.h"
#include "synth/scene/scene.h"

namespace synth {

/// A glTF textureInfo, whichever of tinygltf's types holds it.
struct TextureReference {
  int index = kNone;
  int texcoord_set = 0;
  const tinygltf::ExtensionMap& extensions;

  /// `info` is one of tinygltf's types of textureInfo, and must outlive the reference.
  template <typename TextureInfo>
  static TextureReference of(const TextureInfo& info) {
    return {info.index, info.texCoord, info.extensions};
  }
};

/// Reads a model's textures and images into a scene as they are asked for.
class TextureReader {
 public:
  /// `reading` and `scene` must outlive the reader. Textures that are not needed are left out, with
  /// a note, where their image's file does not exist.
  TextureReader(GltfReading& reading, Scene& scene, NeededTextures needed);

  /// Reads a material's texture of this use. Throws vo::Error if its image cannot be decoded.
  TextureSlot slot(const TextureReference& info, TexelEncoding encoding, NeededTextures use);

 private:
  int texture(int gltf_index, TexelEncoding encoding, NeededTextures use);
  bool is_left_out(int gltf_image, NeededTextures use);
  int image(int gltf_index, TexelEncoding encoding);

  /// The scene's index of each texture or image read so far, by glTF index and encoding.
  using Read = std::map<std::pair<int, TexelEncoding>, int>;

  GltfReading& reading_;
  const GltfModel& model_;
  Scene& scene_;
  NeededTextures needed_;
  MemoryBudget image_budget_;
  Read textures_, images_;
};

}  // namespace synth
