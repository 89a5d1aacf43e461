#pragma once

#include "synth/gltf_document/json_object.h"
#include "synth/gltf_document/notes.h"

namespace synth {

/// Checks the primitives of a document whose buffers have been checked: indices, modes, and that
/// their attributes are of types that glTF or KHR_mesh_quantization allows and of equal counts.
/// Throws vo::Error.
void check_meshes(const JsonObject& root, Notes& notes);

}  // namespace synth
