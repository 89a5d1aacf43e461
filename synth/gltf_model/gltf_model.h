#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include <tiny_gltf.h>

#include "synth/gltf_document/gltf_file.h"
#include "synth/gltf_document/notes.h"

namespace synth {

/// A file that an element of a glTF document names, and that does not exist.
struct MissingFile {
  std::string element;  ///< like "images[3]"
  std::filesystem::path path;
};

/// A checked glTF document with the bytes of its buffers. Images are kept as they are encoded.
struct GltfModel {
  std::filesystem::path path;
  tinygltf::Model content;
  std::map<int, MissingFile> missing_images;  ///< by index of the image

  /// Returns an element's name for messages, like "room.gltf: images[3]".
  std::string place(const std::string& array, int index) const;

  /// Returns an image's name for messages, with that of the file that it is in, like
  /// "room.gltf: images[3] (floor.png)".
  std::string image_place(int index) const;
  std::filesystem::path folder() const { return path.parent_path(); }
};

/// Checks the document, reads its buffers and decodes compressed ones. Throws vo::Error, for a
/// buffer whose file does not exist one that names all files that do not.
GltfModel read_gltf_model(const GltfFile& file, Notes& notes);

/// Throws vo::Error that names all missing images.
[[noreturn]] void fail_for_missing_images(const GltfModel& model);

/// Returns an image's bytes as they are encoded. Throws vo::Error if they cannot be read.
Bytes read_encoded_image(const GltfModel& model, int image);

}  // namespace synth
