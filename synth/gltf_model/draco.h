#pragma once

#include "synth/gltf_document/json_object.h"
#include "synth/gltf_model/gltf_model.h"

namespace synth {

/// Gives each primitive of a checked document that KHR_draco_mesh_compression compresses accessors
/// of what it decodes to. Throws vo::Error for damaged data and for counts other than the
/// primitive's own accessors state.
void decode_draco(const JsonObject& root, GltfModel& model);

}  // namespace synth
