#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/utility.hpp>

#include "tools/cameras/live_camera.h"
#include "tools/cameras/newest_frames.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/topic_arguments.h"
#include "tools/cli/watched_run.h"
#include "tools/commands/commands.h"
#include "tools/commands/track_arguments.h"
#include "tools/commands/track_outcome.h"
#include "tools/depth/mono_run.h"
#include "tools/pictures/panel_writer.h"
#include "tools/point_cloud/keyframe_cloud.h"
#include "tools/report/trajectory_plot.h"
#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/files/output.h"
#include "vo/sequence_odometry/track_frames.h"
#include "vo/sequence_odometry/track_mono.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTrackHelp =
    "Tracks the camera of an RGB-D sequence, a folder as TUM RGB-D, EuRoC, ICL-NUIM, 7-Scenes,\n"
    "ScanNet, Open3D, Redwood or TartanAir have it, or a recording (MCAP, ROS 1 bag), or with\n"
    "--mode mono a video (AVI, MP4, MOV, MKV, WebM) and its --camera, and writes\n"
    "T_world_camera of every tracked frame in TUM format; the world is the first camera's frame.\n"
    "With --mode mono only the images are read, and the depth of the first for --bootstrap rgbd;\n"
    "--preset and --debug-images are for --mode rgbd.\n"
    "Frames that are lost have no pose in the file; frames that are uncertain have one that must\n"
    "not be relied on (the frame log says why). The exit code is then 5, as it is where\n"
    "--mode mono knows a pose's rotation alone.\n"
    "A camera that runs (openni2, openni2:URI, or with --mode mono v4l2, v4l2:DEVICE and its "
    "--camera,\n"
    "as of edvo record) is tracked until Ctrl-C, which ends it well. Frames that come while "
    "others\n"
    "are tracked are dropped and counted.\n"
    "All options that a trajectory was tracked with are written beside it (e_config.toml for\n"
    "e.txt); --config reads them.";

std::string track_examples() {
  std::string text =
      "Examples:\n"
      "  edvo track rgbd_dataset_freiburg1_xyz --camera tum-fr1 --preset paper --out estimate.txt\n"
      "  edvo track sequence --set keyframes.every=5 --set edges.percentile=90 --out e.txt --json\n"
      "  edvo track sequence --debug-images 30 --out e.txt   # pictures in e_panels/\n"
      "  edvo track sequence --out e.txt --frame-log e.csv --time-log e_times.csv   # edvo view "
      "e.txt\n"
      "  edvo track sequence --mode mono --bootstrap auto --out e.txt --frame-log e.csv\n"
      "  edvo track walk.mp4 --mode mono --camera my_camera.toml --out e.txt\n"
      "  edvo track openni2 --live --out e.txt\n"
      "  edvo track v4l2 --mode mono --camera my_camera.toml --live --out e.txt\n"
      "  edvo track robot.mcap --rgb-topic /front/color/image_raw --out e.txt\n\n"
      "Camera presets:\n";
  for (const vo::CameraPreset& preset : vo::camera_presets()) {
    text += "  " + preset.name + std::string(13 - preset.name.size(), ' ') + preset.help + "\n";
  }
  vo::TrackerOptions options = vo::preset_options(vo::TrackerPreset::best_measured);
  vo::MonoOptions mono = vo::mono_options();
  return text + "\nKeys of --set, with the values of preset default:\n" +
         describe_fields(vo::fields_of(options)) + "\nKeys of --set with --mode mono:\n" +
         describe_fields(vo::fields_of(mono));
}

vo::TrackerOptions chosen_options(const TrackArguments& arguments, const Colours& colours) {
  vo::TrackerOptions options =
      vo::preset_options(vo::parse_enum<vo::TrackerPreset>(arguments.preset));
  std::vector<vo::Field> fields = vo::fields_of(options);
  apply_arguments(arguments, fields, colours);
  check_usage([&] { options.validate(); });
  return options;
}

vo::MonoOptions chosen_mono_options(const TrackArguments& arguments, const Colours& colours) {
  vo::MonoOptions options = vo::mono_options();
  std::vector<vo::Field> fields = vo::fields_of(options);
  apply_arguments(arguments, fields, colours);
  check_usage([&] {
    if (!arguments.bootstrap.empty()) {
      options.bootstrap = vo::parse_enum<vo::MonoBootstrap>(arguments.bootstrap);
    }
    options.validate();
  });
  return options;
}

Tracked tracked_rgbd(vo::SequenceResult result, vo::TrackerOptions& options) {
  Tracked tracked{.result = std::move(result), .options = vo::fields_of(options)};
  tracked.log = vo::format_frame_log(tracked.result.frames);
  tracked.note = vo::note_on(tracked.result);
  return tracked;
}

void write_pictures(const TrackArguments& arguments, const vo::SequenceReader& sequence,
                    const vo::SequenceResult& result) {
  vo::write_file(
      beside(arguments.out, kPlotEnding),
      draw_trajectory(sequence.ground_truth(), result.trajectory, vo::TrajectoryAlignment::se3),
      arguments.common.output_policy());
}

/// Prints what was tracked, and says on the page how it went; returns the exit code.
int tell(const TrackArguments& arguments, const Tracked& tracked, WatchedRun& watched,
         const Session& session) {
  const int status = print_tracked(arguments, tracked, session);
  watched.finish(tracked.text());
  return status;
}

int track_rgbd(const TrackArguments& arguments, const std::optional<vo::RgbdCamera>& camera,
               ProgressBar& bar, WatchedRun& watched, const Session& session) {
  const vo::TrackerOptions chosen = chosen_options(arguments, session.err);
  cv::setNumThreads(chosen.align.threads);
  const vo::SequenceReader sequence(arguments.sequence, camera, arguments.max_time_difference,
                                    vo::SequenceContent::colour_and_depth, arguments.topics);
  vo::TrackerOptions options = chosen.starting_from(sequence.camera());
  PanelWriter panels(beside(arguments.out, kPanelsEnding), arguments.debug_images,
                     arguments.common.output_policy(), throw_if_interrupted);
  KeyframeCloud cloud;
  const vo::FrameObserver observer =
      arguments.save_map.empty() ? panels.observer() : cloud.observer(panels.observer());
  watched.begin(tracking_stage(sequence, arguments.sequence, {}));
  Tracked tracked = tracked_rgbd(
      vo::track_sequence(sequence, options, {}, watched.observer(observer), bar.callback()),
      options);
  tracked.sequence_notes = sequence.notes();
  write_tracked(arguments, tracked, cloud);
  if (arguments.debug_images > 0) {
    panels.commit();
    write_pictures(arguments, sequence, tracked.result);
  }
  bar.erase();
  return tell(arguments, tracked, watched, session);
}

/// Returns what a user must know of a monocular trajectory to use it.
std::string note_on(const vo::MonoSequenceResult& result, vo::MonoBootstrap bootstrap) {
  if (result.trajectory.empty()) {
    return result.why_no_pose();
  }
  std::string note =
      is_metric(bootstrap) ? "" : "the scale is arbitrary: evaluate with --align sim3";
  if (result.oriented_poses > 0) {
    note += vo::concat(note.empty() ? "" : "; ", result.oriented_poses, " of ",
                       result.trajectory.size(),
                       " poses are known by their rotation alone, their depths were guessed");
  }
  if (result.scale_uncertain_poses > 0) {
    note += vo::concat(note.empty() ? "" : "; ", result.scale_uncertain_poses, " of ",
                       result.trajectory.size(),
                       " poses are of uncertain scale: it may have changed by a quarter or more");
  }
  return note;
}

Tracked tracked_mono(const vo::MonoSequenceResult& result, vo::MonoOptions& options) {
  return {.result = result.tracking(),
          .options = vo::fields_of(options),
          .log = vo::format_mono_log(result.frames),
          .mono = &result,
          .note = note_on(result, options.bootstrap),
          .sequence_notes = result.sequence_notes,
          .camera = {}};
}

int track_mono(const TrackArguments& arguments, const std::optional<vo::RgbdCamera>& camera,
               ProgressBar& bar, WatchedRun& watched, const Session& session) {
  vo::require(arguments.debug_images == 0,
              "track: --debug-images is for --mode rgbd; "
              "`edvo depth --track` draws monocular maps");
  vo::MonoOptions options = chosen_mono_options(arguments, session.err);
  const vo::MonoInput input{arguments.sequence, camera, arguments.max_time_difference,
                            arguments.depth_file, arguments.topics};
  KeyframeCloud cloud;
  if (watched.page() != nullptr) {
    const vo::SequenceReader images(arguments.sequence, camera, arguments.max_time_difference,
                                    vo::SequenceContent::colour, arguments.topics);
    watched.begin(tracking_stage(images, arguments.sequence, {}));
  }
  const vo::MonoSequenceResult result = vo::track_mono_sequence(
      input, options,
      watched.mono_observer(arguments.save_map.empty() ? vo::MonoObserver()
                                                       : cloud.mono_observer()),
      bar.callback());
  const Tracked tracked = tracked_mono(result, options);
  write_tracked(arguments, tracked, cloud);
  bar.erase();
  return tell(arguments, tracked, watched, session);
}

/// Returns an observer that an interrupt of the user's does not end: the frames end then.
template <typename... Arguments>
std::function<void(Arguments...)> through_interrupts(std::function<void(Arguments...)> observer) {
  if (!observer) {
    return observer;
  }
  return [observer = std::move(observer)](Arguments... arguments) {
    try {
      observer(arguments...);
    } catch (const vo::Error&) {
      if (!is_interrupted()) {
        throw;
      }
    }
  };
}

WatchedStage camera_stage(const LiveCamera& camera) {
  return {.name = "tracking",
          .title = camera.device,
          .frames = 0,
          .camera = camera.camera.pinhole,
          .truth = {},
          .path = {}};
}

vo::Progress camera_progress(const LiveCamera& camera, ProgressBar& bar) {
  return [&](std::size_t frames, std::size_t /*total*/) {
    bar.announce(vo::concat("tracking ", camera.device, ", ", frames, " frames"));
  };
}

/// Ends a camera and tells of it.
void end_camera(const LiveCamera& camera, NewestFrames& frames, Tracked& tracked) {
  const NewestFrames::End end = frames.finish();
  tracked.camera = {camera.device, end.dropped};
  tracked.sequence_notes = camera.notes;
  if (!end.failure.empty()) {
    tracked.sequence_notes.push_back("what the camera gave before it failed is tracked: " +
                                     end.failure);
  }
}

int track_rgbd_camera(const TrackArguments& arguments, const LiveCamera& camera, ProgressBar& bar,
                      WatchedRun& watched, const Session& session) {
  vo::require(camera.has_depth, arguments.sequence, ": has no depth, expected --mode mono");
  const vo::TrackerOptions chosen = chosen_options(arguments, session.err);
  cv::setNumThreads(chosen.align.threads);
  vo::TrackerOptions options = chosen.starting_from(camera.camera);
  KeyframeCloud cloud;
  watched.begin(camera_stage(camera));
  NewestFrames frames(camera, arguments.frames, is_interrupted);
  Tracked tracked = tracked_rgbd(
      vo::track_frames(
          {.camera = camera.camera, .next = [&] { return frames.next(); }}, options, {},
          through_interrupts(watched.observer(arguments.save_map.empty() ? vo::FrameObserver()
                                                                         : cloud.observer({}))),
          camera_progress(camera, bar)),
      options);
  end_camera(camera, frames, tracked);
  write_tracked(arguments, tracked, cloud);
  bar.erase();
  return tell(arguments, tracked, watched, session);
}

int track_mono_camera(const TrackArguments& arguments, const LiveCamera& camera, ProgressBar& bar,
                      WatchedRun& watched, const Session& session) {
  vo::MonoOptions options = chosen_mono_options(arguments, session.err);
  const bool takes_depth = options.bootstrap == vo::MonoBootstrap::rgbd;
  vo::require(!takes_depth || camera.has_depth, arguments.sequence,
              ": has no depth, which --bootstrap rgbd needs");
  vo::MonoOptions started = options;
  started.tracker = options.tracker.starting_from(camera.camera);
  NewestFrames frames(camera, arguments.frames, is_interrupted);
  bool is_first = true;
  const auto next = [&] {
    std::optional<vo::RgbdFrame> frame = frames.next();
    if (frame && !(takes_depth && std::exchange(is_first, false))) {
      frame->depth = {};
    }
    return frame;
  };
  KeyframeCloud cloud;
  watched.begin(camera_stage(camera));
  const vo::MonoSequenceResult result = vo::track_mono_images(
      {.camera = camera.camera.pinhole, .T_world_first = {}, .next = next}, started,
      through_interrupts(watched.mono_observer(arguments.save_map.empty() ? vo::MonoObserver()
                                                                          : cloud.mono_observer())),
      camera_progress(camera, bar));
  Tracked tracked = tracked_mono(result, options);
  end_camera(camera, frames, tracked);
  write_tracked(arguments, tracked, cloud);
  bar.erase();
  return tell(arguments, tracked, watched, session);
}

/// Throws where options contradict the source of the frames.
void check_source(const TrackArguments& arguments) {
  const auto refuse = [&](bool is_given, const char* option, const char* expected) {
    if (is_given) {
      vo::fail_as(vo::ErrorKind::usage, option, ": expected ", expected, ", not ",
                  arguments.sequence);
    }
  };
  if (is_live_camera(arguments.sequence)) {
    const char* expected = "a sequence (edvo record makes one of a camera)";
    refuse(arguments.debug_images > 0, "--debug-images", expected);
    refuse(!arguments.depth_file.empty(), "--depth-file", expected);
    refuse(!arguments.topics.are_free(), "--rgb-topic and the like", expected);
  } else {
    refuse(arguments.frames > 0, "--frames", "a camera (openni2, v4l2)");
    refuse(!arguments.size.empty(), "--size", "a camera (openni2, v4l2)");
  }
}

int track_camera(const TrackArguments& arguments, const std::optional<vo::RgbdCamera>& camera,
                 ProgressBar& bar, WatchedRun& watched, const Session& session) {
  LiveCameraSettings settings{.camera = camera,
                              .max_time_difference = arguments.max_time_difference};
  if (!arguments.size.empty()) {
    settings.size = parse_size(arguments.size);
  }
  const LiveCamera live = open_live_camera(arguments.sequence, settings);
  return vo::parse_enum<TrackMode>(arguments.mode) == TrackMode::mono
             ? track_mono_camera(arguments, live, bar, watched, session)
             : track_rgbd_camera(arguments, live, bar, watched, session);
}

int track(TrackArguments& arguments, const Session& session) {
  read_config(arguments);
  check_source(arguments);
  const std::optional<vo::RgbdCamera> camera = given_camera(arguments.camera);
  vo::require_writable(arguments.out);
  for (const std::string& log : {arguments.frame_log, arguments.time_log}) {
    if (!log.empty()) {
      vo::require_writable(log);
    }
  }
  if (!arguments.save_map.empty()) {
    cloud_format_of(arguments.save_map);
    vo::require_writable(arguments.save_map);
  }
  if (arguments.debug_images > 0 && vo::is_stream(arguments.out)) {
    vo::fail_as(vo::ErrorKind::usage,
                "--debug-images: are written beside --out, expected a file there and not ",
                arguments.out);
  }
  WatchedRun watched(arguments.live);
  ProgressBar bar("tracking", arguments.common.verbosity());
  if (is_live_camera(arguments.sequence)) {
    bar.announce("opening " + arguments.sequence);
    return track_camera(arguments, camera, bar, watched, session);
  }
  bar.announce("reading " + arguments.sequence);
  return vo::parse_enum<TrackMode>(arguments.mode) == TrackMode::mono
             ? track_mono(arguments, camera, bar, watched, session)
             : track_rgbd(arguments, camera, bar, watched, session);
}

}  // namespace

void add_track_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("track", kTrackHelp);
  const auto arguments = std::make_shared<TrackArguments>();
  command.footer(track_examples());
  command
      .add_option("SEQUENCE", arguments->sequence,
                  "folder of a sequence, recording, video, or camera (openni2, v4l2)")
      ->required();
  command.add_option("--out", arguments->out, "trajectory to write")->required();
  add_camera_option(command, arguments->camera);
  command.add_option("--mode", arguments->mode, "rgbd | mono [rgbd]")
      ->check(is_name_of<TrackMode>());
  command.add_option(
      "--bootstrap", arguments->bootstrap,
      "mono: where first depths come from, rgbd | file | flat | random | auto [auto]");
  command.add_option("--depth-file", arguments->depth_file,
                     "mono, bootstrap file: depth of the first image, 16-bit PNG or .npy in "
                     "metres; a stream is PNG");
  command.add_option("--config", arguments->config,
                     "TOML file with the keys of --set, and mode and preset");
  command.add_option("--preset", arguments->preset, "paper | authors | default [default]")
      ->check(is_name_of<vo::TrackerPreset>());
  command.add_option("--set", arguments->assignments, "key=value, may be repeated; keys below")
      ->allow_extra_args(false);
  command.add_option("--frame-log", arguments->frame_log,
                     "CSV: status, termination, points, cost and covariances of every frame");
  command.add_option("--time-log", arguments->time_log,
                     "CSV: time of each stage of every frame, ms");
  command.add_option("--save-map", arguments->save_map,
                     "points of all keyframes with the sigma of each inverse depth, .ply or .pcd");
  command
      .add_option("--debug-images", arguments->debug_images,
                  "a picture of every N-th frame and the trajectory, beside --out")
      ->check(at_least_one());
  add_time_difference_option(command, arguments->max_time_difference,
                             "the stamps of colour and depth");
  command.add_option("--frames", arguments->frames,
                     "of a camera: at most so many; 0 is until Ctrl-C [0]");
  command.add_option("--size", arguments->size, "of a camera: WxH, px, as of edvo record");
  add_topic_options(command, arguments->topics);
  add_live_options(command, arguments->live);
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"--depth-file"},
                         .configurations = {"--camera", "--config"},
                         .outputs = {"--out", "--frame-log", "--time-log"},
                         .read = {"SEQUENCE"},
                         .written = {"--save-map"},
                         .derived = [arguments] { return places_beside(*arguments); },
                         .in_place = {{"--config", kOptionsBesideOut}}});
  command.callback([arguments, &session] { session.status = track(*arguments, session); });
}

}  // namespace tools
