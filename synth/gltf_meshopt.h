#pragma once

#include "synth/gltf_json.h"
#include "synth/gltf_model.h"

namespace synth {

/// EXT_meshopt_compression: the buffer views that hold compressed data, and the fallback buffers
/// that have none. Checks what the document says of them. Throws vo::Error.
void check_meshopt(const JsonObject& root);

/// Whether the buffer has no bytes of its own, as compressed views stand for it.
bool is_meshopt_fallback(const JsonObject& buffer);

/// Points each compressed view of a checked document to a new buffer with what it decodes to.
/// Throws vo::Error for damaged data.
void decode_meshopt(const JsonObject& root, GltfModel& model);

}  // namespace synth
