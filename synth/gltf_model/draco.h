#pragma once

#include "synth/gltf_document/json_object.h"
#include "synth/gltf_model/gltf_model.h"

namespace synth {

/// Decodes each primitive of a checked document that KHR_draco_mesh_compression compresses, and
/// replaces its accessors by decoded ones. Throws vo::Error for damaged data and for counts that
/// differ from those of the original accessors.
void decode_draco(const JsonObject& root, GltfModel& model);

}  // namespace synth
