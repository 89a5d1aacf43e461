#pragma once

#include "synth/gltf_document/json_object.h"

namespace synth {

/// Checks skins, the nodes that wear them and the attributes that follow their joints. Throws
/// vo::Error. The node graph must have been checked.
void check_skins(const JsonObject& root);

}  // namespace synth
