#pragma once

#include "synth/gltf_document/json_object.h"

namespace synth {

/// The name of the glTF extension whose primitives are compressed by Draco.
inline constexpr const char* kDracoExtension = "KHR_draco_mesh_compression";

/// Checks the buffer views, modes and attributes of primitives that KHR_draco_mesh_compression
/// compresses. Throws vo::Error.
void check_draco(const JsonObject& root);

}  // namespace synth
