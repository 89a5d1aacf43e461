#pragma once

#include <string>
#include <vector>

#include "synth/gltf_model/gltf_reading.h"
#include "synth/gltf_model/nodes.h"

namespace synth {

/// The animations that GltfOptions::animation names. Throws vo::Error for keys that are not in
/// order and for a name that no animation has.
std::vector<Animation> read_animations(GltfReading& reading, const NodeForest& forest,
                                       const std::string& wanted);

}  // namespace synth
