#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "synth/gltf_document/json_object.h"
#include "synth/gltf_document/notes.h"

namespace synth {

inline constexpr const char* kAnimationPointerExtension = "KHR_animation_pointer";

/// A property of an element that an animation's channel names by its JSON pointer.
struct AnimationPointer {
  std::string_view array;  ///< "lights" (of KHR_lights_punctual), "materials" or "nodes"
  std::size_t index = 0;
  std::string_view property;  ///< "intensity", "color", "emissiveFactor", "emissiveStrength" or, of
                              ///< nodes, the name of a channel's path
};

/// Returns what a pointer of KHR_animation_pointer names; nothing if this is not supported.
std::optional<AnimationPointer> parse_animation_pointer(std::string_view pointer);

/// Checks animations and morph targets of a document whose buffers, meshes and nodes have been
/// checked: the types and counts of accessors, and that samplers, targets and weights fit together.
/// Throws vo::Error.
void check_motion(const JsonObject& root, Notes& notes);

}  // namespace synth
