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
  std::size_t stride = 0;  ///< bytes per element
  std::size_t count = 0;
  std::string mode, filter;
};

/// Reads a buffer view's extension object. Throws vo::Error for missing or mistyped members.
MeshoptView read_meshopt_view(const JsonObject& extension);

/// Checks the buffer views that EXT_meshopt_compression compresses, and that no others refer to
/// fallback buffers without data. Throws vo::Error.
void check_meshopt(const JsonObject& root);

/// Returns whether EXT_meshopt_compression marks the buffer as a fallback for compressed views.
bool is_meshopt_fallback(const JsonObject& buffer);

}  // namespace synth
