#pragma once

#include <filesystem>

#include "synth/gltf/gltf.h"
#include "synth/scene/scene.h"
#include "synth/scene/scene_labels.h"

namespace synth {

/// A scene, and what its elements are called in its file.
struct LabelledScene {
  Scene scene;
  SceneLabels labels;
};

/// Reads a .gltf or .glb file as load_gltf does, which returns the scene alone.
LabelledScene load_labelled_gltf(const std::filesystem::path& path, const GltfOptions& options,
                                 Notes* notes = nullptr);

/// Reads a file as load_labelled_gltf does, with all nodes in Scene::motion also where nothing
/// moves.
LabelledScene load_with_nodes(const std::filesystem::path& path, const GltfOptions& options,
                              Notes* notes);

}  // namespace synth
