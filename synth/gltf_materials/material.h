#pragma once

#include <vector>

#include "synth/gltf_materials/texture_reader.h"
#include "synth/gltf_model/gltf_reading.h"
#include "synth/scene/scene.h"

namespace synth {

/// Returns the emissive factor and strength of a glTF material.
Brightness emission_of(const tinygltf::Material& source);

/// Reads a model's materials, with their textures and images, into a scene as they are asked for.
class MaterialReader {
 public:
  /// `reading` and `scene` must outlive the reader. Textures that are not needed are left out, with
  /// a note, where their image's file does not exist; lengths are times `scale`.
  MaterialReader(GltfReading& reading, Scene& scene, NeededTextures needed, double scale);

  /// Returns the scene's index of a glTF material, kNone for kNone. Throws vo::Error if an image
  /// that the material needs cannot be decoded.
  int material(int gltf_index);

  /// Returns the glTF index of each of the scene's materials.
  std::vector<int> sources() const;

 private:
  Material read_material(const tinygltf::Material& source);
  void read_surface(const tinygltf::Material& source, Material& material);
  void read_maps(const tinygltf::Material& source, Material& material);
  void read_specular_maps(const tinygltf::Material& source, Material& material);
  void read_layers(const tinygltf::Material& source, MaterialLayers& layers);
  bool may_begin_to_shine() const;
  template <typename TextureInfo>
  TextureSlot surface_map(const TextureInfo& info, TexelEncoding encoding);

  GltfReading& reading_;
  const GltfModel& model_;
  Scene& scene_;
  double scale_;
  std::vector<int> materials_;  ///< scene index by glTF index; kNone until it is read
  TextureReader textures_;
};

}  // namespace synth
