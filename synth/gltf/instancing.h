#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "synth/gltf_model/gltf_reading.h"

namespace synth {

/// Returns whether the node shows instances of its mesh by EXT_mesh_gpu_instancing.
bool is_instancing(const tinygltf::Node& node);

/// Returns T_node_instance of each instance of the node's mesh. Throws vo::Error beginning with
/// `place` for rotations that are not unit quaternions.
std::vector<Eigen::Affine3d> read_instancing(GltfReading& reading, const tinygltf::Node& node,
                                             const std::string& place);

}  // namespace synth
