#pragma once

#include <filesystem>
#include <memory>

#include "synth/gltf/gltf.h"
#include "synth/scene/scene.h"

namespace synth {

/// A glTF file that is read when its scene is first asked for, and once, by all copies.
class SceneFile {
 public:
  SceneFile() = default;
  explicit SceneFile(std::filesystem::path path, GltfOptions options = {});

  const std::filesystem::path& path() const { return path_; }
  const Scene& scene() const;  ///< throws vo::Error; of one thread
  const Notes& notes() const;  ///< what it leaves out

 private:
  struct Content {
    Notes notes;
    Scene scene;
  };

  const Content& content() const;

  std::filesystem::path path_;
  GltfOptions options_;
  std::shared_ptr<std::unique_ptr<const Content>> content_;
};

}  // namespace synth
