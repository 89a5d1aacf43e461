#pragma once

#include "synth/gltf_document/json_object.h"
#include "synth/gltf_model/gltf_model.h"

namespace synth {

/// Decodes each buffer view of a checked document that EXT_meshopt_compression compresses into a
/// new buffer, to which the view then refers. Throws vo::Error for damaged data.
void decode_meshopt(const JsonObject& root, GltfModel& model);

}  // namespace synth
