#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "synth/camera/make_renderer.h"
#include "synth/rig/render_rig.h"
#include "synth/sensor/pinhole_effects.h"
#include "synth/sensor/preset.h"
#include "synth/sequence/labels_file.h"
#include "synth/sequence/render_plan.h"
#include "synth/sequence/render_sequence.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/watched_run.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "tools/scenario/actor_tables.h"
#include "tools/scenario/class_tables.h"
#include "vo/core/error.h"
#include "vo/frames/depth_units.h"
#include "vo/rigs/rig_file.h"

namespace tools {
namespace {

constexpr const char* kRenderHelp =
    "Renders a glTF 2.0 scene as an RGB-D sequence in the layout of the TUM RGB-D benchmark:\n"
    "rgb/ and depth/ with their lists, groundtruth.txt (T_world_camera; camera x right, y down,\n"
    "z forward), camera.toml and sequence.toml. Depth is planar, at pixel centres, 0 = none; of\n"
    "an equirectangular camera it is along the ray; with --float-depth also as float32 metres in\n"
    "depth_float/NNNNNN.npy.\n\n"
    "DIR appears when all frames are there. Until then they are in DIR.part, which any number of\n"
    "processes with the same inputs may fill at once (--shard, --frames) or one after the other: "
    "a\n"
    "finished frame is not rendered again. To join parts from several machines, copy what their\n"
    "DIR.part hold into one and give the command without --shard; a file that was cut or damaged\n"
    "on the way is found by its record in DIR.part/edvo-done, and rendered again.\n\n"
    "With --rig FILE all cameras of a rig are rendered, the path being that of the body that "
    "carries\n"
    "them: each makes a sequence DIR/NAME, beside DIR/rig.toml and DIR/groundtruth.txt "
    "(T_world_body).";

constexpr const char* kRenderExamples =
    "Examples:\n"
    "  edvo render room.gltf --trajectory poses.txt --size 640x480 \\\n"
    "       --intrinsics 525,525,319.5,239.5 --out sequence\n"
    "  edvo render room.gltf --path orbit --orbit.centre 0,1,0 --orbit.radius 1.5 \\\n"
    "       --camera tum-default --duration 10 --out sequence\n"
    "  edvo render room.gltf --path spline --trajectory keys.txt --rate 30 --out sequence\n"
    "  edvo render room.gltf --path explore --duration 20 --explore.seed 3 --out sequence\n"
    "  edvo render room.gltf --path pan --move.eye 0,1.4,0.5 --move.target 0,1.2,-2 \\\n"
    "       --move.turn-deg 90 --shake.amplitude 0.003 --shake.amplitude-deg 0.3 --out sequence\n"
    "  edvo render room.gltf --trajectory poses.txt --sensor kinect-v1 \\\n"
    "       --shutter.exposure-time 0.02 --depth.delay 0 --out sequence\n"
    "  edvo render room.gltf --trajectory poses.txt --plan\n"
    "  for k in 1 2 3 4; do edvo render room.gltf --trajectory poses.txt --shard $k/4 \\\n"
    "       --out sequence & done; wait";

struct RenderArguments {
  CommonOptions common;
  LiveArguments live;
  std::string scene;
  synth::GltfOptions file;
  CameraArguments camera;
  PathArguments path;
  std::string frames;
  std::string shard;
  bool plan = false;
  bool strict = false;
  bool float_depth = false;
  std::string channels;
  std::string classes;
  std::string actors;
  std::string float_format = "npy";
  synth::RenderJob job;
  std::string out;
  std::string rig_file;
  std::optional<vo::Rig> rig;
  std::vector<synth::RenderJob> cameras;  ///< the jobs of the rig's cameras

  synth::RigJob rig_job() const { return {*rig, job}; }  ///< of a rig alone

  /// Returns the number of frames of all cameras.
  std::size_t frames_of_all() const {
    return job.recipe.truth.size() * (rig ? rig->cameras.size() : 1);
  }
};

void print_notes(const RenderArguments& arguments, const std::vector<std::string>& notes,
                 const Colours& colours) {
  for (const std::string& note : notes) {
    if (!arguments.common.quiet) {
      std::cerr << colours.paint(Tone::caution, "note") << ": " << note << "\n";
    }
  }
}

std::string summary(const RenderArguments& arguments, const synth::RenderOutcome& outcome) {
  const std::size_t frames = arguments.frames_of_all();
  const std::string depth =
      outcome.depth_coverage
          ? vo::concat(", depth in ", std::round(1e3 * *outcome.depth_coverage) / 10,
                       " % of their pixels")
          : "";
  const std::string cameras =
      arguments.rig ? vo::concat(" of ", arguments.rig->cameras.size(), " cameras") : "";
  if (outcome.missing == 0) {
    return vo::concat(arguments.out, ": ", frames, " frames", cameras, depth,
                      outcome.was_there ? ", there already with the same inputs" : "");
  }
  return vo::concat(outcome.folder.string(), ": ", frames - outcome.missing, " of ", frames,
                    " frames", cameras, depth, "; ", arguments.out, " appears when all are there");
}

std::vector<std::string> camera_names(const vo::Rig& rig) {
  std::vector<std::string> names;
  for (const vo::RigCamera& camera : rig.cameras) {
    names.push_back(camera.name);
  }
  return names;
}

void print(const RenderArguments& arguments, const synth::RenderOutcome& outcome,
           const Colours& colours) {
  std::vector<std::string> notes = outcome.notes;
  if (outcome.depth_beyond_16_bit > 0) {
    const double units =
        (arguments.rig ? arguments.rig->cameras.front().camera : arguments.job.recipe.camera)
            .depth_units_per_m;
    notes.push_back(vo::concat(outcome.depth_beyond_16_bit, " depth pixels are beyond ",
                               vo::farthest_in_16_bit(units), " m, which 16 bit cannot hold at ",
                               units,
                               " units per m, and became 0; --float-depth has "
                               "them, and a camera with fewer depth_units_per_m"));
  }
  print_notes(arguments, notes, colours);
  if (!outcome.warning.empty()) {
    std::cerr << colours.paint(Tone::caution, "warning") << ": " << outcome.warning << "\n";
  }
  if (!arguments.common.json) {
    std::cout << summary(arguments, outcome) << "\n";
    return;
  }
  nlohmann::ordered_json result = {{"sequence", arguments.out},
                                   {"folder", outcome.folder.string()},
                                   {"frames", arguments.frames_of_all()},
                                   {"rendered", outcome.rendered},
                                   {"missing", outcome.missing},
                                   {"path_length_m", vo::path_length(arguments.job.recipe.truth)},
                                   {"was_there", outcome.was_there},
                                   {"depth_beyond_16_bit", outcome.depth_beyond_16_bit},
                                   {"depth_coverage", nullptr},
                                   {"warning", outcome.warning},
                                   {"notes", outcome.notes}};
  if (outcome.depth_coverage) {
    result["depth_coverage"] = *outcome.depth_coverage;
  }
  if (arguments.rig) {
    result["cameras"] = camera_names(*arguments.rig);
  }
  std::cout << json_text(json_document({"render"}, result));
}

void print(const RenderArguments& arguments, const synth::RenderPlan& plan) {
  if (arguments.common.json) {
    const nlohmann::ordered_json result = {
        {"frames", plan.frames},     {"there", plan.there},
        {"files", plan.files},       {"bytes", std::round(plan.bytes)},
        {"cpu_s", plan.processor_s}, {"measured_frames", plan.measured}};
    std::cout << json_text(json_document({"render_plan"}, result));
    return;
  }
  std::cout << "frames    " << plan.frames << ", of which " << plan.there << " are there\n"
            << "files     " << plan.files << "\n"
            << std::fixed << std::setprecision(1)  //
            << "size      " << plan.bytes / kBytesPerMegabyte << " MB\n"
            << "CPU time  " << plan.processor_s << " s, as " << plan.measured
            << " of the frames take\n";
}

synth::RenderJob chosen_job(const RenderArguments& arguments) {
  synth::RenderJob job = arguments.job;
  if (!arguments.classes.empty()) {
    job.recipe.channels.classes = load_classes(arguments.classes);
  }
  job.recipe.camera = chosen_camera(arguments.camera);
  check_usage([&] {
    arguments.file.validate();
    job.recipe.camera.validate();
    job.recipe.render.validate();
    job.recipe.sensor.validate();
    synth::require_pinhole_effects(job.recipe.sensor, job.recipe.camera.model);
    if (!arguments.rig) {
      synth::require_drawable(job.recipe.camera.model, job.recipe.sensor.shutter,
                              job.recipe.render);
    }
    if (!arguments.channels.empty()) {
      job.recipe.channels.channels = synth::parse_channels(arguments.channels);
    }
    job.recipe.channels.float_format = vo::parse_enum<vo::FloatFormat>(arguments.float_format);
    if (!arguments.rig) {  // whose cameras' channels differ
      job.recipe.channels.validate();
    }
    vo::require(arguments.classes.empty() || synth::has_labels(job.recipe.channels),
                "--classes: expected --channels with class, instance or material");
    vo::require(!arguments.out.empty() || arguments.plan, "--out: expected a folder to make");
  });
  synth::GltfOptions file = arguments.file;
  file.needed = arguments.rig ? synth::needed_textures({*arguments.rig, job})
                              : synth::needed_textures(job.recipe);
  job.scene = synth::SceneFile(arguments.scene, file, load_actors(arguments.actors));
  if (!arguments.frames.empty()) {
    synth::parse_frames(arguments.frames, job.share);
  }
  if (!arguments.shard.empty()) {
    synth::parse_shard(arguments.shard, job.share);
  }
  synth::TimedPath path = synth::make_path(chosen_path(arguments.path), job.scene);
  job.recipe.truth = synth::sample(path.path, path.times);
  job.recipe.path = std::move(path.path);
  job.recipe.float_depth = arguments.float_depth ? vo::FloatDepth::npy : vo::FloatDepth::none;
  return job;
}

/// Renders a rig's cameras, of which the page shows the first.
synth::RenderOutcome rendered_rig(const RenderArguments& arguments, WatchedRun& watched,
                                  const vo::Progress& progress) {
  const synth::SequenceRecipe& first = arguments.cameras.front().recipe;
  watched.begin(rendering_stage(first, arguments.scene));
  return synth::render_rig(arguments.rig_job(), arguments.cameras, arguments.out,
                           arguments.common.output_policy(), watched.progress(progress),
                           rendered_frames_on(watched, first.camera.depth_units_per_m));
}

synth::RenderOutcome rendered(const RenderArguments& arguments, WatchedRun& watched,
                              const vo::Progress& progress) {
  if (arguments.rig) {
    return rendered_rig(arguments, watched, progress);
  }
  watched.begin(rendering_stage(arguments.job.recipe, arguments.scene));
  return synth::render_sequence(
      arguments.job, arguments.out, arguments.common.output_policy(), watched.progress(progress),
      rendered_frames_on(watched, arguments.job.recipe.camera.depth_units_per_m));
}

/// Throws vo::Error if the scene has what would be left out of the pictures.
void refuse_what_is_left_out(const RenderArguments& arguments) {
  const std::vector<std::string> notes =
      arguments.rig ? synth::notes_on_rig(arguments.rig_job(), arguments.cameras)
                    : synth::notes_on_scene(arguments.job);
  vo::require(notes.empty(), arguments.scene, ": ", notes.empty() ? "" : notes.front(),
              ", expected a scene of which nothing is left out, as --strict says");
}

void render(RenderArguments& arguments, const Session& session) {
  const auto limit = arguments.common.limit_threads();
  ProgressBar bar("rendering", arguments.common.verbosity());
  bar.announce("reading " + arguments.scene);
  if (!arguments.rig_file.empty()) {
    arguments.rig = vo::read_rig(arguments.rig_file);
  }
  arguments.job = chosen_job(arguments);
  if (arguments.rig) {
    arguments.cameras = synth::camera_jobs(arguments.rig_job());
  }
  if (arguments.strict) {
    refuse_what_is_left_out(arguments);
  }
  if (arguments.plan) {
    bar.announce("planning");
    const synth::RenderPlan plan =
        arguments.rig ? synth::plan_rig(arguments.rig_job(), arguments.cameras, arguments.out)
                      : synth::plan_sequence(arguments.job, arguments.out);
    bar.erase();
    if (arguments.rig) {
      print_notes(arguments, synth::notes_on_stamps(arguments.rig_job(), arguments.cameras),
                  session.err);
    }
    print(arguments, plan);
    return;
  }
  bar.announce();
  WatchedRun watched(arguments.live);
  const synth::RenderOutcome outcome = rendered(arguments, watched, bar.callback());
  bar.erase();
  print(arguments, outcome, session.err);
  watched.finish(summary(arguments, outcome));
}

std::vector<vo::Field> render_fields(synth::RenderJob& job) {
  std::vector<vo::Field> fields = vo::fields_of(job.recipe.render);
  std::erase_if(fields, [](const vo::Field& field) { return field.key == "denoise"; });  // a flag
  for (vo::Field& field : fields) {
    field.key = field.key == "kind" ? "renderer" : field.key;
  }
  return fields;
}

/// Returns the sensor's fields with the preset first, so that it does not reset other options.
std::vector<vo::Field> sensor_fields(synth::SensorOptions& sensor) {
  std::vector<vo::Field> fields = vo::fields_of(sensor);
  fields.front().key = "sensor";
  fields.front().set = [&sensor](std::string_view text) {
    sensor = synth::preset_options(vo::parse_enum<synth::SensorPreset>(text));
  };
  return fields;
}

}  // namespace

void add_render_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("render", kRenderHelp);
  const auto arguments = std::make_shared<RenderArguments>();
  command.footer(kRenderExamples);
  command.add_option("SCENE", arguments->scene, "glTF 2.0 file, .gltf or .glb")->required();
  command.add_option("--out", arguments->out, "folder to make; required without --plan");
  add_camera_options(command, arguments->camera);
  command
      .add_option("--rig", arguments->rig_file,
                  "FILE.toml of several cameras on one body, whose path is given")
      ->excludes("--size", "--intrinsics", "--fov", "--camera")
      ->group("Camera");
  add_path_options(command, arguments->path);
  command.add_flag("--plan", arguments->plan, "frames, bytes and CPU time, nothing written")
      ->group("Scale");
  command.add_flag("--strict", arguments->strict,
                   "refuse a scene of which anything is left out, which is a note otherwise");
  command.add_option("--frames", arguments->frames, "A:B, only frames A to B - 1")->group("Scale");
  command.add_option("--shard", arguments->shard, "K/N, only the K-th of N parts, K from 1")
      ->group("Scale");
  command.add_flag("--float-depth", arguments->float_depth, "write depth_float/*.npy too");
  command
      .add_option("--channels", arguments->channels,
                  "exact ground truth, all or some of depth,normal,instance,material,flow,\n"
                  "occlusion,edges,moving,velocity,imu, and of a rig's stereo pairs disparity and\n"
                  "stereo_occlusion; sequence.toml says how each is written; class is one more,\n"
                  "which needs --classes, and depth_beyond, behind glass and in mirrors, which\n"
                  "are not in all")
      ->group("Ground truth");
  command
      .add_option("--classes", arguments->classes,
                  "FILE.toml with tables [[class]]: name, and patterns nodes = [\"*chair*\"] and\n"
                  "materials = [...]; the first class that matches counts")
      ->group("Ground truth");
  command
      .add_option("--float-format", arguments->float_format,
                  "of channels in floats, npy | pfm | tiff [npy]")
      ->group("Ground truth");
  synth::TruthOptions& truth = arguments->job.recipe.channels;
  add_field_options(command, vo::fields_of(truth.edges, "edges."), "Ground truth");
  add_field_options(command, vo::fields_of(truth.imu, "imu."), "Ground truth");
  add_scene_options(command, arguments->file);
  add_actor_option(command, arguments->actors);
  add_field_options(command, render_fields(arguments->job), "Rendering");
  command
      .add_flag("--denoise", arguments->job.recipe.render.denoise,
                "with --mode path: remove noise from the colour")
      ->group("Rendering");
  add_field_options(command, sensor_fields(arguments->job.recipe.sensor), "Sensor");
  add_live_options(command, arguments->live);
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"SCENE", "--trajectory"},
                         .configurations = {"--camera", "--rig", "--classes", "--actor"},
                         .written = {"--out"}});
  command.callback([arguments, &session] { render(*arguments, session); });
}

}  // namespace tools
