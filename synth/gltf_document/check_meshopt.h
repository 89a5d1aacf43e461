#pragma once

#include <cstddef>
#include <string>

#include "synth/gltf_document/json_object.h"

namespace synth {

/// The name of the glTF extension whose buffer views hold data compressed by meshoptimizer.
inline constexpr const char* kMeshoptExtension = "EXT_meshopt_compression";

/// The EXT_meshopt_compression object of a buffer view: where the compressed bytes are and what
/// they decode to.
struct MeshoptView {
  std::size_t buffer = 0;
  std::size_t offset = 0;
  std::size_t length = 0;
  std::size_t stride = 0;  ///< bytes
  std::size_t count = 0;
  std::string mode, filter;
};

/// Reads the extension's object. Throws vo::Error for members of another type.
MeshoptView read_meshopt_view(const JsonObject& extension);

/// Checks what the document says of buffer views compressed by EXT_meshopt_compression, and of the
/// fallback buffers that have no data. Throws vo::Error.
void check_meshopt(const JsonObject& root);

/// Whether the buffer is a fallback: it has no bytes of its own, as compressed views stand for it.
bool is_meshopt_fallback(const JsonObject& buffer);

}  // namespace synth
