#include "synth/sequence/render_sequence.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include "synth/camera/make_renderer.h"
#include "synth/camera/sequence_camera.h"
#include "synth/scene/scene_hash.h"
#include "synth/sequence/depth_coverage.h"
#include "synth/sequence/labels_file.h"
#include "synth/sequence/share_renderer.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/version.h"
#include "vo/dataset/camera_file.h"
#include "vo/frames/depth_units.h"
#include "vo/hashing/content_hash.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/output_folders/staged_folder.h"
#include "vo/text_files/toml_file.h"

namespace synth {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "sequence.toml";

/// Returns a hash of the files of each channel of motion, as TOML: the poses do not tell how the
/// camera moves between them.
std::string describe_motion(const SequenceRecipe& recipe) {
  std::string text;
  for (const TruthChannel channel : recipe.channels.channels) {
    TruthOptions alone = recipe.channels;
    alone.channels = {channel};
    const std::vector<vo::NamedBytes> files = encode_motion(alone, recipe.path, recipe.truth);
    vo::ContentHash hash;
    for (const vo::NamedBytes& file : files) {
      hash.add(file.bytes);
    }
    if (!files.empty()) {
      text += vo::concat("motion_hash.", vo::to_string(channel), " = \"", hash.hex(), "\"\n");
    }
  }
  return text;
}

/// Returns texts as an array of TOML.
std::string array_of(const std::vector<std::string>& texts) {
  std::string array;
  for (const std::string& text : texts) {
    array += vo::concat(array.empty() ? "" : ", ", vo::quoted_toml(text));
  }
  return vo::concat("[", array, "]");
}

/// Returns the classes that truth/labels.json tells apart, as TOML.
std::string describe_classes(const TruthOptions& options) {
  std::string tables;
  for (const SurfaceClass& one : options.classes) {
    tables += vo::concat(tables.empty() ? "" : ", ", "{ name = ", vo::quoted_toml(one.name),
                         ", nodes = ", array_of(one.nodes),
                         ", materials = ", array_of(one.materials), " }");
  }
  return has_labels(options) && !tables.empty() ? vo::concat("classes = [", tables, "]\n") : "";
}

/// Returns the format of each ground-truth channel and the options it was made with, as TOML.
std::string describe_channels(const SequenceRecipe& recipe) {
  TruthOptions options = recipe.channels;
  std::string text;
  for (const TruthChannel channel : options.channels) {
    text += vo::concat(
        "truth.", vo::to_string(channel), " = ",
        vo::quoted_toml(truth_convention(channel, options.float_format, recipe.camera.model)),
        "\n");
  }
  if (options.has(TruthChannel::edges)) {
    text += vo::format_toml(vo::fields_of(options.edges, "edges."));
  }
  if (options.has(TruthChannel::imu)) {
    text += vo::format_toml(vo::fields_of(options.imu, "imu."));
  }
  if (std::any_of(options.channels.begin(), options.channels.end(), is_of_pair)) {
    text += vo::concat("truth.stereo_baseline = ", vo::format_real(options.stereo_baseline), "\n");
  }
  return text + describe_classes(options) + describe_motion(recipe);
}

/// Returns numbers as an array of TOML.
template <typename Vector>
std::string array_of_reals(const Vector& numbers) {
  std::string array;
  for (const double number : numbers) {
    array += vo::concat(array.empty() ? "" : ", ", vo::format_real(number));
  }
  return vo::concat("[", array, "]");
}

/// Returns a projector as TOML: its pose in the camera, and a hash of its pattern's size and
/// values.
std::string describe_projector(const Projector& projector, const std::string& key) {
  vo::ContentHash pattern;
  const std::array size = {projector.pattern.cols, projector.pattern.rows};
  pattern.add_values(std::span<const int>(size));
  pattern.add_values(
      std::span<const float>(projector.pattern.ptr<float>(), projector.pattern.total()));
  const vo::SE3& T = projector.T_camera_projector;
  return vo::concat(key, "name = ", vo::quoted_toml(projector.name), "\n",      //
                    key, "position = ", array_of_reals(T.translation()), "\n",  //
                    key, "orientation = ", array_of_reals(T.rotation().coeffs()), "\n", key,
                    "half_extent = ", array_of_reals(projector.half_extent), "\n", key,
                    "power = ", vo::format_real(projector.power), "\n", key, "pattern_hash = \"",
                    pattern.hex(), "\"\n");
}

/// Returns how an infrared camera sees, as TOML; nothing for one that sees colours.
std::string describe_infrared(const SequenceRecipe& recipe) {
  if (!recipe.infrared) {
    return "";
  }
  std::string text =
      vo::concat("infrared.scene_light = ", vo::format_real(recipe.infrared->scene_light), "\n");
  for (std::size_t i = 0; i < recipe.infrared->projectors.size(); ++i) {
    text += describe_projector(recipe.infrared->projectors[i],
                               vo::concat("infrared.projector.", i, "."));
  }
  return text;
}

bool moves_between_stamps(const SensorOptions& sensor) {
  return sensor.shutter.exposure_time > 0 || sensor.shutter.readout_time > 0 ||
         sensor.depth.delay != 0;
}

/// Returns a hash of the camera's poses shortly before and after each stamp.
std::string motion_hash(const SequenceRecipe& recipe) {
  const CameraPath path = path_of(recipe);
  vo::Trajectory around;
  for (const vo::StampedPose& pose : recipe.truth) {
    for (const double time : {-0.01, -0.003, 0.003, 0.01}) {
      around.push_back({pose.timestamp + time, path(pose.timestamp + time)});
    }
  }
  return vo::content_hash(vo::format_trajectory(around));
}

/// Removes the fields whose keys begin with `prefix` unless what they set `is_on`, so that a
/// sequence without it has the bytes that versions without it gave.
void keep_if_on(std::vector<vo::Field>& fields, const std::string& prefix, bool is_on) {
  std::erase_if(fields,
                [&](const vo::Field& field) { return !is_on && field.key.starts_with(prefix); });
}

/// Returns the manifest: conventions that a reader must know, and the inputs that identify a
/// folder.
std::string format_manifest(const RenderJob& job, const Scene& scene) {
  std::string text =
      "# Frames: T_world_camera in groundtruth.txt, camera x right, y down, z forward;"
      " world is the scene's.\n";
  text += vo::concat("# Depth: along the ",
                     job.recipe.camera.model.has_optical_axis() ? "optical axis" : "ray",
                     " at the pixel's centre, 0 = none.");
  text +=
      vo::concat(" 16 bit hold up to ", vo::farthest_in_16_bit(job.recipe.camera.depth_units_per_m),
                 " m; beyond, 0.\n");
  text +=
      "# Colour: sRGB unless sensor.response says otherwise, mean over the pixel's area.\n"
      "# Stamps: the middle of the exposure of the middle row, (height - 1) / 2, and the pose is\n"
      "# that of this instant; row v is exposed readout_time (v - (height - 1) / 2) / height "
      "later,\n"
      "# its depth is that of the middle of its exposure. Depth is stamped depth.delay later, its\n"
      "# poses are in groundtruth_depth.txt then.\n";
  text += vo::concat("generator = \"edvo ", vo::version(), "\"\n");
  text += "scene = " + vo::quoted_toml(job.scene.path().filename().string()) + "\n";
  text += "scene_hash = \"" + content_hash(scene) + "\"\n";
  return text + format_recipe(job);
}

std::vector<std::size_t> all_frames(const RenderJob& job) {
  return frames_of({}, job.recipe.truth.size());
}

std::vector<std::size_t> share_of(const RenderJob& job) {
  return frames_of(job.share, job.recipe.truth.size());
}

}  // namespace

RenderOutcome render_sequence(const RenderJob& job, const fs::path& folder,
                              const vo::OutputPolicy& policy, const vo::Progress& progress,
                              const MadeFrameObserver& observe) {
  job.recipe.camera.validate();
  share_of(job);  // throws before any work
  require_drawable(job.recipe.camera.model, job.recipe.sensor.shutter, job.recipe.render);
  const Scene& scene = job.scene.scene();
  require_drawable(scene, job.recipe.render);
  const vo::StagedContent content = sequence_content(job);
  RenderOutcome outcome =
      render_share(share_job(job, content), folder, policy, {progress, observe});
  outcome.notes = notes_on_scene(job);
  for (std::string& note : notes_on_classes(job.scene, job.recipe.channels)) {
    outcome.notes.push_back(std::move(note));
  }
  outcome.depth_coverage = depth_coverage(job.recipe, all_frames(job), outcome.folder);
  if (outcome.depth_coverage) {
    outcome.warning = warn_of_coverage(scene, job.recipe, *outcome.depth_coverage);
  }
  return outcome;
}

std::vector<std::string> notes_on_scene(const RenderJob& job) {
  std::vector<std::string> notes = job.scene.notes();
  for (std::string& note : notes_on_materials(job.scene.scene(), job.recipe.render)) {
    notes.push_back(std::move(note));
  }
  if (job.recipe.render.kind == RendererKind::rasterizer &&
      sees_materials(job.scene.scene(), job.recipe.sensor)) {
    notes.emplace_back(
        "sensor.depth.materials is left out: the rasterizer measures every surface; the ray tracer "
        "sees what glass, mirrors and dark surfaces do to depth");
  }
  if (job.recipe.render.kind == RendererKind::rasterizer &&
      job.recipe.sensor.depth.multipath.is_on()) {
    notes.emplace_back(
        "sensor.depth.multipath is left out: the rasterizer follows no light from surface to "
        "surface; the ray tracer does");
  }
  return notes;
}

ShareJob share_job(const RenderJob& job, const vo::StagedContent& content) {
  return {content, share_of(job), [&job]() -> PartMaker {
            const std::shared_ptr<const FrameGenerator> generator = frame_generator(job);
            return [generator](std::size_t frame) { return generator->make(frame); };
          }};
}

std::unique_ptr<const FrameGenerator> frame_generator(
    const RenderJob& job, std::shared_ptr<const RenderersOverTime> renderers) {
  return std::make_unique<const FrameGenerator>(job.scene.scene(), job.recipe,
                                                instance_classes(job.scene, job.recipe.channels),
                                                std::move(renderers));
}

std::vector<vo::NamedBytes> sequence_files(const RenderJob& job) {
  std::vector<vo::NamedBytes> files = sequence_files(job.recipe);
  if (has_labels(job.recipe.channels)) {
    files.push_back(labels_file(job.scene, job.recipe.channels));
  }
  return files;
}

std::string format_recipe(const RenderJob& job) {
  std::string text = vo::concat("frames = ", job.recipe.truth.size(), "\n");
  text +=
      "trajectory_hash = \"" + vo::content_hash(vo::format_trajectory(job.recipe.truth)) + "\"\n";
  SequenceRecipe recipe = job.recipe;
  if (moves_between_stamps(recipe.sensor)) {
    text += "shutter_motion_hash = \"" + motion_hash(recipe) + "\"\n";
  }
  if (recipe.scene_delay != 0) {
    text += vo::concat("scene_delay = ", vo::format_real(recipe.scene_delay), "\n");
  }
  text += std::string("float_depth = ") +
          (recipe.float_depth == vo::FloatDepth::npy ? "true" : "false") + "\n";
  vo::RgbdCameraModel camera = written_camera(recipe);
  text += vo::format_projection(camera.model, "camera.") +
          vo::format_toml(vo::fields_of(camera, "camera."));
  std::vector<vo::Field> render = vo::fields_of(recipe.render, "render.");
  keep_if_on(render, "render.denoise", recipe.render.denoise);
  keep_if_on(render, "render.denoise_frames", recipe.render.denoise_frames > 0);
  keep_if_on(render, "render.anisotropy", recipe.render.anisotropy > 1);
  std::vector<vo::Field> sensor = vo::fields_of(recipe.sensor, "sensor.");
  keep_if_on(sensor, "sensor.flicker.", recipe.sensor.flicker.is_on());
  keep_if_on(sensor, "sensor.depth.turn", !recipe.sensor.depth.turn.isZero(0));
  keep_if_on(sensor, "sensor.depth.materials.", sees_materials(job.scene.scene(), recipe.sensor));
  keep_if_on(sensor, "sensor.depth.materials.solids",
             recipe.sensor.depth.materials.solids != SolidGlass::straight);
  keep_if_on(sensor, "sensor.depth.multipath.", recipe.sensor.depth.multipath.is_on());
  text += vo::format_toml(render) + vo::format_toml(sensor);
  return text + describe_infrared(recipe) + describe_channels(recipe) +
         format_actors(job.scene.actors());
}

std::string format_actors(const std::vector<ActorOptions>& actors) {
  std::string text;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    ActorOptions actor = actors[i];
    actor.file = actor.file.filename();
    text += vo::format_toml(vo::fields_of(actor, vo::concat("actor.", i, ".")));
  }
  return text;
}

vo::NamedBytes sequence_manifest(const RenderJob& job) {
  return {kManifest, format_manifest(job, job.scene.scene())};
}

}  // namespace synth
