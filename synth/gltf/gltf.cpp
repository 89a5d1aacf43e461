#include "synth/gltf/gltf.h"

#include <cmath>
#include <string>
#include <vector>

#include "synth/gltf/gltf_scene.h"
#include "synth/gltf/labelled_scene.h"
#include "synth/gltf_document/check_document.h"
#include "synth/gltf_document/gltf_file.h"
#include "synth/gltf_document/notes.h"
#include "synth/gltf_model/gltf_model.h"
#include "synth/scene/scene_motion.h"
#include "vo/core/error.h"

namespace synth {
namespace {

void note_what_is_newer(const nlohmann::json& document, Notes& notes) {
  const nlohmann::json& asset = document.at("asset");
  for (const char* key : {"version", "minVersion"}) {
    const std::string version = asset.value(key, "2.0");
    if (version != "2.0") {
      add_note(notes, "the file is of glTF " + version + " and read as 2.0");
    }
  }
  for (const std::string& name : document.value("extensionsUsed", std::vector<std::string>())) {
    if (!is_supported_extension(name)) {
      add_note(notes, "the extension " + name + " is ignored");
    }
  }
}

LabelledScene load(const GltfFile& file, const GltfOptions& options, Notes* notes) {
  Notes ignored;
  Notes& left_out = notes != nullptr ? *notes : ignored;
  options.validate();
  const GltfModel model = read_gltf_model(file, left_out);
  if (options.needed == NeededTextures::all && !model.missing_images.empty()) {
    fail_for_missing_images(model);
  }
  note_what_is_newer(file.json, left_out);
  return read_scene(model, options, left_out);
}

/// Drops the motion of a scene in which nothing moves; what constant curves say holds for ever.
LabelledScene without_needless_motion(LabelledScene labelled) {
  if (!moves(labelled.scene) && !moves_cameras(labelled.scene)) {
    if (!labelled.scene.motion.animations.empty()) {
      labelled.scene = scene_at(labelled.scene, 0);
    }
    labelled.scene.motion = {};
  }
  return labelled;
}

}  // namespace

void GltfOptions::validate() const {
  vo::require(std::isfinite(scale) && scale > 0, "scene scale: is ", scale,
              ", expected a positive number");
  vo::require(std::isfinite(environment_turn), "environment turn: is ", environment_turn,
              ", expected degrees");
  vo::require(std::isfinite(environment_strength) && environment_strength >= 0,
              "environment strength: is ", environment_strength, ", expected 0 or more");
}

Scene load_gltf(const std::filesystem::path& path, const GltfOptions& options, Notes* notes) {
  return load_labelled_gltf(path, options, notes).scene;
}

Scene load_gltf(const std::filesystem::path& path, Notes* notes) {
  return load_gltf(path, {}, notes);
}

LabelledScene load_labelled_gltf(const std::filesystem::path& path, const GltfOptions& options,
                                 Notes* notes) {
  return without_needless_motion(load_with_nodes(path, options, notes));
}

LabelledScene load_with_nodes(const std::filesystem::path& path, const GltfOptions& options,
                              Notes* notes) {
  return load(read_gltf_file(path), options, notes);
}

Scene parse_gltf(std::span<const std::uint8_t> content, const std::filesystem::path& path,
                 const GltfOptions& options, Notes* notes) {
  return without_needless_motion(load(parse_gltf_file(content, path), options, notes)).scene;
}

}  // namespace synth
