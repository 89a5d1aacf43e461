#pragma once

#include <filesystem>
#include <vector>

#include "synth/gltf/actor.h"
#include "synth/gltf/labelled_scene.h"

namespace synth {

/// Reads a scene and the scenes of the actors that go through it as one: the actors' instances,
/// materials and lights follow the file's own, and their motion is the scene's, whose animations
/// start with it; they have no cameras. Of an actor's file the needed textures are those of
/// `options`. Throws vo::Error, also where an actor's file does not have what its options ask for.
LabelledScene load_with_actors(const std::filesystem::path& path, const GltfOptions& options,
                               const std::vector<ActorOptions>& actors, Notes* notes = nullptr);

}  // namespace synth
