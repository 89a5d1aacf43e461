#pragma once

#include "synth/gltf_document/json_object.h"

namespace synth {

/// Checks animations and morph targets of a document of which buffers, meshes and nodes have
/// been checked: types and counts of accessors, and that what refers to each other fits. Throws
/// vo::Error.
void check_motion(const JsonObject& root);

}  // namespace synth
