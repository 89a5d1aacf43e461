#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "synth/gltf_json.h"
#include "synth/gltf_reading.h"

namespace synth {

/// Checks the nodes' EXT_mesh_gpu_instancing: types and counts of their attributes. Throws
/// vo::Error.
void check_instancing(const JsonObject& root);

bool is_instancing(const tinygltf::Node& node);

/// T_node_instance of each instance of the node's mesh. Throws vo::Error beginning with `place` for
/// rotations that are none.
std::vector<Eigen::Affine3d> read_instancing(GltfReading& reading, const tinygltf::Node& node,
                                             const std::string& place);

}  // namespace synth
