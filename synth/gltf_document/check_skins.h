#pragma once

#include "synth/gltf_document/json_object.h"
#include "synth/gltf_document/notes.h"

namespace synth {

/// Checks skins, the nodes that use them and the attributes JOINTS_n and WEIGHTS_n. The node graph
/// must have been checked. Throws vo::Error.
void check_skins(const JsonObject& root, Notes& notes);

}  // namespace synth
