#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <tiny_gltf.h>

#include "synth/gltf_document/gltf_file.h"

namespace synth {

/// A checked glTF document with the bytes of its buffers. Images are kept as they are encoded.
struct GltfModel {
  std::filesystem::path path;
  tinygltf::Model content;

  /// "room.gltf: images[3]"
  std::string place(const std::string& array, int index) const;
  std::filesystem::path folder() const { return path.parent_path(); }
};

/// Checks the document and reads its buffers. Throws vo::Error.
GltfModel read_gltf_model(const GltfFile& file);

/// The encoded bytes of an image.
Bytes read_encoded_image(const GltfModel& model, int image);

}  // namespace synth
