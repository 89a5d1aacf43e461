#include "synth/gltf/animated_brightness.h"

#include <algorithm>
#include <cstddef>

#include "synth/gltf/placed_lights.h"
#include "synth/gltf_materials/material.h"

namespace synth {
namespace {

BrightnessFactor factor_of(const AnimationPointer& pointer) {
  return pointer.property == "intensity"        ? BrightnessFactor::light_strength
         : pointer.property == "color"          ? BrightnessFactor::light_color
         : pointer.property == "emissiveFactor" ? BrightnessFactor::emission_color
                                                : BrightnessFactor::emission_strength;
}

AnimationCurve times(AnimationCurve curve, float unit) {
  for (float& value : curve.values) {
    value *= unit;
  }
  return curve;
}

bool has_brightness_channels(const SceneMotion& motion) {
  return std::any_of(motion.animations.begin(), motion.animations.end(),
                     [](const Animation& animation) { return !animation.brightness.empty(); });
}

}  // namespace

std::size_t count_of_targets(const AnimationPointer& pointer, const ShiningSources& sources) {
  const bool is_light = BrightnessChannel{.factor = factor_of(pointer)}.is_of_light();
  const std::vector<int>& elements = is_light ? sources.lights : sources.materials;
  return static_cast<std::size_t>(
      std::count(elements.begin(), elements.end(), static_cast<int>(pointer.index)));
}

std::vector<BrightnessChannel> brightness_channels(const AnimationPointer& pointer,
                                                   const AnimationCurve& curve, const Scene& scene,
                                                   const ShiningSources& sources) {
  BrightnessChannel channel{.factor = factor_of(pointer)};
  const std::vector<int>& elements = channel.is_of_light() ? sources.lights : sources.materials;
  std::vector<BrightnessChannel> channels;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (at(elements[i]) != pointer.index) {
      continue;
    }
    const bool is_intensity = channel.factor == BrightnessFactor::light_strength;
    channel.target = static_cast<int>(i);
    channel.curve =
        is_intensity ? times(curve, intensity_unit(scene.lights[i].kind, sources.scale)) : curve;
    channels.push_back(channel);
  }
  return channels;
}

void read_brightness(const GltfModel& model, const ShiningSources& sources, SceneMotion& motion) {
  if (!has_brightness_channels(motion)) {
    return;
  }
  for (const int index : sources.lights) {
    motion.light_brightness.push_back(
        brightness_of(model.content.lights[at(index)], sources.scale));
  }
  for (const int index : sources.materials) {
    motion.emission.push_back(emission_of(model.content.materials[at(index)]));
  }
}

}  // namespace synth
