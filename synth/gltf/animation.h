#pragma once

#include <string>
#include <vector>

#include "synth/gltf_model/gltf_reading.h"
#include "synth/gltf_model/nodes.h"

namespace synth {

/// Reads the animations that `wanted`, a GltfOptions::animation, selects. Throws vo::Error for key
/// times that do not increase, rotations that are not unit and a name that no animation has.
std::vector<Animation> read_animations(GltfReading& reading, const NodeForest& forest,
                                       const std::string& wanted);

}  // namespace synth
