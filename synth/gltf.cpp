#include "synth/gltf.h"

#include <string>
#include <vector>

#include "synth/gltf_check.h"
#include "synth/gltf_file.h"
#include "synth/gltf_model.h"
#include "synth/gltf_notes.h"
#include "synth/gltf_scene.h"

namespace synth {
namespace {

void note_unknown_extensions(const nlohmann::json& document, Notes& notes) {
  for (const std::string& name : document.value("extensionsUsed", std::vector<std::string>())) {
    if (!is_supported_extension(name)) {
      add_note(notes, "the extension " + name + " is ignored");
    }
  }
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const GltfOptions& options, Notes* notes) {
  Notes ignored;
  Notes& left_out = notes != nullptr ? *notes : ignored;
  const GltfFile file = read_gltf_file(path);
  const GltfModel model = read_gltf_model(file);
  note_unknown_extensions(file.json, left_out);
  return read_scene(model, options, left_out);
}

Scene load_gltf(const std::filesystem::path& path, Notes* notes) {
  return load_gltf(path, {}, notes);
}

}  // namespace synth
