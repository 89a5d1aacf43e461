#pragma once

#include <filesystem>
#include <memory>

#include "synth/gltf.h"
#include "synth/scene.h"

namespace tools {

/// A glTF file that is read when its scene is first asked for, and once, by all copies.
class SceneFile {
 public:
  SceneFile() = default;
  explicit SceneFile(std::filesystem::path path, synth::GltfOptions options = {});

  const std::filesystem::path& path() const { return path_; }
  const synth::Scene& scene() const;  ///< throws vo::Error; of one thread
  const synth::Notes& notes() const;  ///< what it leaves out

 private:
  struct Content {
    synth::Notes notes;
    synth::Scene scene;
  };

  const Content& content() const;

  std::filesystem::path path_;
  synth::GltfOptions options_;
  std::shared_ptr<std::unique_ptr<const Content>> content_;
};

}  // namespace tools
