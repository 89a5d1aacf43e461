#pragma once

#include "synth/gltf_document/json_object.h"
#include "synth/gltf_document/notes.h"

namespace synth {

/// Checks animations and morph targets of a document whose buffers, meshes and nodes have been
/// checked: the types and counts of accessors, and that samplers, targets and weights fit together.
/// Throws vo::Error.
void check_motion(const JsonObject& root, Notes& notes);

}  // namespace synth
