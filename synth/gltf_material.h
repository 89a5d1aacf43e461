#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "synth/gltf.h"
#include "synth/gltf_model.h"
#include "synth/scene.h"

namespace synth {

/// Which texture coordinates a material's base colour uses, and how they map to the image.
struct TexcoordMapping {
  int set = 0;  ///< n of TEXCOORD_n
  Eigen::Affine2f T_image_texcoord = Eigen::Affine2f::Identity();
};

/// The mapping of a glTF material; the default for kNone.
TexcoordMapping texcoord_mapping(const GltfModel& model, int material);

/// Puts those materials, textures and images of a model into a scene that are asked for.
class MaterialReader {
 public:
  /// All three must outlive the reader.
  MaterialReader(const GltfModel& model, Scene& scene, Notes& notes);

  /// The scene's index of a glTF material; kNone stays kNone. Throws vo::Error if an image that
  /// it needs cannot be decoded.
  int material(int gltf_index);

 private:
  Material read_material(const tinygltf::Material& source);
  Eigen::Vector3f read_emission(const tinygltf::Material& source);
  int texture(int gltf_index);
  int image(int gltf_index);
  void note_what_is_left_out(const tinygltf::Material& source);

  const GltfModel& model_;
  Scene& scene_;
  Notes& notes_;
  std::vector<int> materials_, textures_, images_;  ///< scene indices, kNone where not read yet
};

}  // namespace synth
