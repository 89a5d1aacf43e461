#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "synth/gltf_document/json_object.h"

namespace synth {

/// Of each node.
using Parents = std::vector<std::optional<std::size_t>>;

/// Throws vo::Error when a node has two parents or is its own.
Parents find_parents(const std::vector<JsonObject>& nodes);

/// Checks nodes, skins, cameras, lights and scenes of a document: indices, transforms, and that
/// the nodes form trees of which scenes name the roots. Throws vo::Error.
void check_node_graph(const JsonObject& root);

}  // namespace synth
