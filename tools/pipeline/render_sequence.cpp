#include "tools/pipeline/render_sequence.h"

#include <iterator>
#include <string_view>

#include "synth/gltf.h"
#include "synth/scene_hash.h"
#include "tools/version.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/hash.h"
#include "vo/io/camera_file.h"
#include "vo/io/toml_file.h"
#include "vo/io/trajectory_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "sequence.toml";

/// What a reader of the folder must know, and what two equal folders have in common.
std::string format_manifest(const RenderJob& job, const synth::Scene& scene) {
  synth::RenderOptions render = job.recipe.render;
  synth::SensorOptions sensor = job.recipe.sensor;
  std::string text =
      "# Frames: T_world_camera in groundtruth.txt, camera x right, y down, z forward;"
      " world is the scene's.\n"
      "# Depth: along the optical axis at the pixel's centre, 0 = none.\n"
      "# Colour: sRGB, mean over the pixel's area.\n";
  text += vo::concat("generator = \"edvo ", version(), "\"\n");
  text += "scene = " + vo::quoted_toml(job.scene.filename().string()) + "\n";
  text += "scene_hash = \"" + vo::to_hex(synth::content_hash(scene)) + "\"\n";
  text += vo::concat("frames = ", job.recipe.truth.size(), "\n");
  vo::ContentHash truth;
  truth.add(vo::format_trajectory(job.recipe.truth));
  text += "trajectory_hash = \"" + vo::to_hex(truth.value()) + "\"\n";
  text += std::string("float_depth = ") +
          (job.recipe.float_depth == vo::FloatDepth::npy ? "true" : "false") + "\n";
  vo::RgbdCamera camera = job.recipe.camera;
  text += vo::format_toml(vo::fields_of(camera, "camera."));
  text += vo::format_toml(vo::fields_of(render, "render."));
  text += vo::format_toml(vo::fields_of(sensor, "sensor."));
  return text;
}

std::size_t files_in(const fs::path& folder) {
  return fs::is_directory(folder)
             ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}))
             : 0;
}

bool holds(const fs::path& folder, const std::string& manifest, std::size_t frames) {
  return fs::is_regular_file(folder / kManifest) && vo::read_file(folder / kManifest) == manifest &&
         files_in(folder / "rgb") == frames && files_in(folder / "depth") == frames;
}

}  // namespace

RenderOutcome render_sequence(const RenderJob& job, const fs::path& folder,
                              vo::ExistingOutput existing, const vo::Progress& progress) {
  job.recipe.camera.validate();
  RenderOutcome outcome;
  const synth::Scene scene = synth::load_gltf(job.scene, &outcome.notes);
  const std::string manifest = format_manifest(job, scene);
  if (holds(folder, manifest, job.recipe.truth.size())) {
    outcome.was_there = true;
    return outcome;
  }
  vo::require_replaceable(folder, kManifest, existing);
  vo::OutputFolder output(folder, kManifest, existing);
  synth::generate_sequence(scene, job.recipe, output.partial(), progress);
  vo::write_file(output.partial() / kManifest, manifest);
  output.commit();
  return outcome;
}

}  // namespace tools
