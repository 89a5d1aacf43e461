#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "synth/gltf_document/json_object.h"

namespace synth {

/// The parent of each glTF node by its index; nothing for a root node.
using Parents = std::vector<std::optional<std::size_t>>;

/// Returns each node's parent. Throws vo::Error if a node has two parents or is its own parent.
Parents find_parents(const std::vector<JsonObject>& nodes);

/// Throws vo::Error beginning with the object's place if its rotation, a quaternion or absent, is
/// not of length 1.
void require_unit_rotation(const std::vector<double>& rotation, const JsonObject& object);

/// Checks the nodes, cameras, lights and scenes of a document: indices, transforms, and that the
/// nodes form trees whose roots are what scenes list. Throws vo::Error.
void check_node_graph(const JsonObject& root);

}  // namespace synth
