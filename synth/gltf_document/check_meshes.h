#pragma once

#include "synth/gltf_document/json_object.h"

namespace synth {

/// Checks the primitives of a document of which the buffers have been checked: indices, modes, and
/// that their attributes are of types that glTF and KHR_mesh_quantization allow and of one count.
/// Throws vo::Error.
void check_meshes(const JsonObject& root);

}  // namespace synth
