#include "synth/gltf/scene_file.h"

#include <numbers>
#include <utility>

#include "synth/environment/environment.h"
#include "synth/gltf/actors.h"

namespace synth {

namespace {

/// Returns the environment that the options name, otherwise the file's own, as they turn and scale
/// it.
Environment environment_of(const GltfOptions& options, Environment of_file) {
  Environment environment =
      options.environment.empty() ? std::move(of_file) : read_environment(options.environment);
  environment.turn = options.environment_turn * std::numbers::pi / 180;
  environment.radiance *= options.environment_strength;
  return environment;
}

}  // namespace

SceneFile::SceneFile(std::filesystem::path path, GltfOptions options,
                     std::vector<ActorOptions> actors)
    : path_(std::move(path)),
      options_(std::move(options)),
      actors_(std::move(actors)),
      content_(std::make_shared<std::unique_ptr<const Content>>()) {}

const SceneFile::Content& SceneFile::content() const {
  if (*content_ == nullptr) {
    Content read;
    read.labelled = actors_.empty() ? load_labelled_gltf(path_, options_, &read.notes)
                                    : load_with_actors(path_, options_, actors_, &read.notes);
    Scene& scene = read.labelled.scene;
    scene.environment = environment_of(options_, std::move(scene.environment));
    *content_ = std::make_unique<const Content>(std::move(read));
  }
  return **content_;
}

const Scene& SceneFile::scene() const {
  return content().labelled.scene;
}

const SceneLabels& SceneFile::labels() const {
  return content().labelled.labels;
}

const Notes& SceneFile::notes() const {
  return content().notes;
}

}  // namespace synth
