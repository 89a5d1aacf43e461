#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <tiny_gltf.h>

#include "synth/gltf_document/gltf_file.h"
#include "synth/gltf_document/notes.h"

namespace synth {

/// A checked glTF document with the bytes of its buffers. Images are kept as they are encoded.
struct GltfModel {
  std::filesystem::path path;
  tinygltf::Model content;

  /// Returns an element's name for messages, like "room.gltf: images[3]".
  std::string place(const std::string& array, int index) const;
  std::filesystem::path folder() const { return path.parent_path(); }
};

/// Checks the document, reads its buffers and decodes compressed ones. Throws vo::Error.
GltfModel read_gltf_model(const GltfFile& file, Notes& notes);

/// Returns an image's bytes as they are encoded. Throws vo::Error if they cannot be read.
Bytes read_encoded_image(const GltfModel& model, int image);

}  // namespace synth
