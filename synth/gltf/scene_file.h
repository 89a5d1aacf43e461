#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "synth/gltf/actor.h"
#include "synth/gltf/labelled_scene.h"

namespace synth {

/// A glTF file, and the actors that go through its scene, that is read once, for all copies of this
/// object, when its scene is first needed.
class SceneFile {
 public:
  SceneFile() = default;
  explicit SceneFile(std::filesystem::path path, GltfOptions options = {},
                     std::vector<ActorOptions> actors = {});

  const std::filesystem::path& path() const { return path_; }
  const GltfOptions& options() const { return options_; }
  const std::vector<ActorOptions>& actors() const { return actors_; }
  const Scene& scene() const;         ///< reads on first use; throws vo::Error; not thread-safe
  const SceneLabels& labels() const;  ///< names of the scene's elements; reads as `scene` does
  const Notes& notes() const;         ///< what the scene leaves out of the file

 private:
  struct Content {
    Notes notes;
    LabelledScene labelled;
  };

  const Content& content() const;

  std::filesystem::path path_;
  GltfOptions options_;
  std::vector<ActorOptions> actors_;
  std::shared_ptr<std::unique_ptr<const Content>> content_;
};

}  // namespace synth
