#pragma once

#include <string>
#include <vector>

#include "synth/gltf/animated_brightness.h"
#include "synth/gltf_model/gltf_reading.h"
#include "synth/gltf_model/nodes.h"

namespace synth {

/// AnimatedElements are what animations change: the scene's nodes, and what shines in it.
struct AnimatedElements {
  const NodeForest& forest;
  const Scene& scene;
  const ShiningSources& shining;
};

/// Reads the animations that `wanted`, a GltfOptions::animation, selects. Throws vo::Error for key
/// times that do not increase, rotations that are not unit, brightness below 0 and a name that no
/// animation has.
std::vector<Animation> read_animations(GltfReading& reading, const AnimatedElements& elements,
                                       const std::string& wanted);

}  // namespace synth
