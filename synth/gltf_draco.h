#pragma once

#include "synth/gltf_json.h"
#include "synth/gltf_model.h"

namespace synth {

/// KHR_draco_mesh_compression: checks what the document says of compressed primitives. Throws
/// vo::Error.
void check_draco(const JsonObject& root);

/// Gives each compressed primitive of a checked document accessors of what it decodes to. Throws
/// vo::Error for damaged data and for counts other than the primitive's own accessors state.
void decode_draco(const JsonObject& root, GltfModel& model);

}  // namespace synth
