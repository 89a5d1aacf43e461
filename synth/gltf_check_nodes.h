#pragma once

#include "synth/gltf_json.h"

namespace synth {

/// Checks nodes, skins, cameras, lights and scenes of a document: indices, transforms, and that
/// the nodes form trees of which scenes name the roots. Throws vo::Error.
void check_node_graph(const JsonObject& root);

}  // namespace synth
