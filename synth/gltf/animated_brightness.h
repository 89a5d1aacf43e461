#pragma once

#include <cstddef>
#include <vector>

#include "synth/gltf_document/check_motion.h"
#include "synth/gltf_model/gltf_model.h"
#include "synth/scene/scene.h"

namespace synth {

/// The glTF elements that a scene's lights and materials were read from.
struct ShiningSources {
  std::vector<int> lights;     ///< of each of Scene::lights, index into KHR_lights_punctual's
  std::vector<int> materials;  ///< of each of Scene::materials
  double scale = 1;            ///< GltfOptions::scale
};

/// Returns the number of lights and materials of the scene that a pointer changes.
std::size_t count_of_targets(const AnimationPointer& pointer, const ShiningSources& sources);

/// Returns the channels by which a pointer at a light or a material changes the scene: one for each
/// of its lights or materials that was read from there. `curve` has the file's units.
std::vector<BrightnessChannel> brightness_channels(const AnimationPointer& pointer,
                                                   const AnimationCurve& curve, const Scene& scene,
                                                   const ShiningSources& sources);

/// States how bright each of the scene's lights and surfaces is while no animation plays, if one
/// changes any.
void read_brightness(const GltfModel& model, const ShiningSources& sources, SceneMotion& motion);

}  // namespace synth
