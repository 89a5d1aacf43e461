#include "synth/gltf/scene_file.h"

#include <numbers>
#include <utility>

#include "vo/core/error.h"
#include "vo/image_files/rgbe.h"

namespace synth {
namespace {

Environment read_environment(const GltfOptions& options) {
  Environment environment;
  environment.radiance = vo::read_rgbe(options.environment);
  environment.turn = options.environment_turn * std::numbers::pi / 180;
  const cv::Size size = environment.radiance.size();
  vo::require(size.width == 2 * size.height, options.environment, ": is ", size.width, " x ",
              size.height, " px, expected an equirectangular image, twice as wide as high");
  environment.radiance *= options.environment_strength;
  return environment;
}

}  // namespace

SceneFile::SceneFile(std::filesystem::path path, GltfOptions options)
    : path_(std::move(path)),
      options_(std::move(options)),
      content_(std::make_shared<std::unique_ptr<const Content>>()) {}

const SceneFile::Content& SceneFile::content() const {
  if (*content_ == nullptr) {
    Content read;
    read.scene = load_gltf(path_, options_, &read.notes);
    if (!options_.environment.empty()) {
      read.scene.environment = read_environment(options_);
    }
    *content_ = std::make_unique<const Content>(std::move(read));
  }
  return **content_;
}

const Scene& SceneFile::scene() const {
  return content().scene;
}

const Notes& SceneFile::notes() const {
  return content().notes;
}

}  // namespace synth
