#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>

#include "tools/cli/exit_code.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/topic_arguments.h"
#include "tools/cli/watched_run.h"
#include "tools/commands/commands.h"
#include "tools/commands/track_arguments.h"
#include "tools/depth/mono_run.h"
#include "tools/json/document.h"
#include "tools/pictures/panel_writer.h"
#include "tools/point_cloud/keyframe_cloud.h"
#include "tools/point_cloud/point_cloud.h"
#include "tools/report/report.h"
#include "tools/report/trajectory_plot.h"
#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/evaluation/evaluate.h"
#include "vo/files/output.h"
#include "vo/motion_files/trajectory_file.h"
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
    "All options that a trajectory was tracked with are written beside it (e_config.toml for\n"
    "e.txt); --config reads them.";

std::string track_examples() {
  std::string text =
      "Examples:\n"
      "  edvo track rgbd_dataset_freiburg1_xyz --camera tum-fr1 --preset paper --out estimate.txt\n"
      "  edvo track sequence --set keyframes.every=5 --set edges.percentile=90 --out e.txt --json\n"
      "  edvo track sequence --debug-images 30 --out e.txt   # pictures in e_panels/\n"
      "  edvo track sequence --mode mono --bootstrap auto --out e.txt --frame-log e.csv\n"
      "  edvo track walk.mp4 --mode mono --camera my_camera.toml --out e.txt\n"
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

/// A sequence that was tracked in either mode.
struct Tracked {
  vo::SequenceResult result;
  std::vector<vo::Field> options;
  std::string log;                               ///< CSV with a line per frame
  const vo::MonoSequenceResult* mono = nullptr;  ///< result of mode mono
  std::string note;                              ///< what a user of the trajectory must know
  std::vector<std::string> sequence_notes;       ///< what in the sequence's files was mended

  bool is_complete() const {
    return result.tracked_fraction() == 1 && result.uncertain() == 0 &&
           (mono == nullptr || mono->oriented_poses + mono->scale_uncertain_poses == 0);
  }
};

void write_results(const TrackArguments& arguments, const Tracked& tracked) {
  vo::write_file(arguments.out, vo::format_trajectory(tracked.result.trajectory),
                 arguments.common.output_policy());
  write_config(arguments, tracked.options);
  if (!arguments.frame_log.empty()) {
    vo::write_file(arguments.frame_log, tracked.log, arguments.common.output_policy());
  }
}

void write_map(const TrackArguments& arguments, KeyframeCloud& cloud) {
  if (!arguments.save_map.empty()) {
    vo::write_file(arguments.save_map, encode(cloud.finish(), cloud_format_of(arguments.save_map)),
                   arguments.common.output_policy());
  }
}

/// Returns what is known of the scale at each keyframe of a monocular run.
nlohmann::ordered_json scales_json(const vo::MonoSequenceResult& mono) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const vo::MonoResult& frame : mono.frames) {
    if (frame.tracking.is_keyframe) {
      json.push_back({{"timestamp", frame.tracking.timestamp},
                      {"scale_drift", frame.scale.drift},
                      {"scale_sigma", frame.scale.sigma},
                      {"joins_maps", frame.joins_maps}});
    }
  }
  return json;
}

/// Returns how many frames are lost or uncertain for each reason.
nlohmann::ordered_json reasons_json(const vo::SequenceResult& result) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [reason, frames] : result.reasons()) {
    json[std::string(vo::to_string(reason))] = frames;
  }
  return json;
}

/// Returns how sure the last pose is, relative to the first frame; null without a pose.
nlohmann::ordered_json last_pose_json(const vo::SequenceResult& result) {
  const auto last = std::find_if(result.frames.rbegin(), result.frames.rend(), [](const auto& f) {
    return f.status != vo::TrackingStatus::lost;
  });
  if (last == result.frames.rend()) {
    return nullptr;
  }
  const vo::Vector6d variance = last->absolute_covariance.diagonal();
  constexpr double kDegreesPerRadian = 180 / std::numbers::pi;
  return {{"timestamp", last->timestamp},
          {"sigma_m", std::sqrt(variance.head<3>().sum())},
          {"sigma_deg", kDegreesPerRadian * std::sqrt(variance.tail<3>().sum())}};
}

nlohmann::ordered_json summary(const TrackArguments& arguments, const Tracked& tracked) {
  nlohmann::ordered_json json = {{"sequence", arguments.sequence}, {"estimate", arguments.out}};
  if (tracked.mono != nullptr) {
    json["mode"] = arguments.mode;
  }
  json["frames"] = tracked.result.frames.size();
  json["tracked_fraction"] = tracked.result.tracked_fraction();
  json["uncertain"] = tracked.result.uncertain();
  json["reasons"] = reasons_json(tracked.result);
  json["keyframes"] = tracked.result.keyframes();
  json["ms_per_frame"] = time_json(vo::summarize(tracked.result.times));
  if (tracked.mono != nullptr) {
    json["mapping_ms"] = tracked.mono->mapping_ms();
    json["oriented_poses"] = tracked.mono->oriented_poses;
    json["scale_uncertain_poses"] = tracked.mono->scale_uncertain_poses;
    json["keyframe_scales"] = scales_json(*tracked.mono);
  } else {
    json["preset"] = arguments.preset;
    json["moving_fraction"] = tracked.result.moving_fraction();
    json["last_pose"] = last_pose_json(tracked.result);
    json["typical_depth_m"] = tracked.result.typical_depth_m();
  }
  json["note"] = tracked.note;
  json["sequence_notes"] = tracked.sequence_notes;
  json["options"] = fields_json(tracked.options);
  return json;
}

/// Returns how many frames have a pose, and how many of those are uncertain, for people.
std::string describe_status(const vo::SequenceResult& result, const Colours& colours) {
  const std::string counts =
      vo::concat(result.trajectory.size(), " of ", result.frames.size(), " frames tracked");
  const bool is_lost = result.trajectory.size() < result.frames.size();
  const std::string uncertain =
      result.uncertain() > 0 ? vo::concat(result.uncertain(), " of them uncertain") : "";
  return (is_lost ? colours.paint(Tone::bad, counts) : counts) + ", " +
         colours.paint(Tone::caution, uncertain) + (uncertain.empty() ? "" : ", ");
}

/// Prints the result, its note last, and returns the exit code.
int print(const TrackArguments& arguments, const Tracked& tracked, const Session& session) {
  const auto [out, colours] = speech_beside(
      session,
      {vo::is_stream(arguments.out) ? vo::kStdoutPath : arguments.out, arguments.frame_log});
  const vo::SequenceResult& result = tracked.result;
  if (arguments.common.json) {
    out << json_text(json_document({"track"}, summary(arguments, tracked)));
  } else {
    const vo::TimeSummary times = vo::summarize(result.times);
    out << arguments.out << ": " << describe_status(result, colours) << result.keyframes()
        << " keyframes, " << times.median_ms << " ms per frame (median; pyramid "
        << times.pyramid_ms << ", edges " << times.edges_ms << ", alignment " << times.alignment_ms
        << (tracked.mono != nullptr ? vo::concat(", mapping ", tracked.mono->mapping_ms()) : "")
        << ")\n"
        << (result.trajectory.empty() || tracked.note.empty()
                ? ""
                : colours.paint(Tone::caution, tracked.note) + "\n");
    out << note_lines(tracked.sequence_notes, colours);
  }
  if (result.trajectory.empty() && !tracked.note.empty()) {
    std::cerr << error_line(session.err, tracked.note);
  }
  return tracked.is_complete() ? exit_code::kOk : exit_code::kTrackingLost;
}

void write_pictures(const TrackArguments& arguments, const vo::SequenceReader& sequence,
                    const vo::SequenceResult& result) {
  vo::write_file(
      beside(arguments.out, "_trajectory.svg"),
      draw_trajectory(sequence.ground_truth(), result.trajectory, vo::TrajectoryAlignment::se3),
      arguments.common.output_policy());
}

int track_rgbd(const TrackArguments& arguments, const std::optional<vo::RgbdCamera>& camera,
               ProgressBar& bar, WatchedRun& watched, const Session& session) {
  const vo::TrackerOptions chosen = chosen_options(arguments, session.err);
  cv::setNumThreads(chosen.align.threads);
  const vo::SequenceReader sequence(arguments.sequence, camera, arguments.max_time_difference,
                                    vo::SequenceContent::colour_and_depth, arguments.topics);
  vo::TrackerOptions options = chosen.starting_from(sequence.camera());
  PanelWriter panels(beside(arguments.out, "_panels"), arguments.debug_images,
                     arguments.common.output_policy(), throw_if_interrupted);
  KeyframeCloud cloud;
  const vo::FrameObserver observer =
      arguments.save_map.empty() ? panels.observer() : cloud.observer(panels.observer());
  watched.begin(tracking_stage(sequence, arguments.sequence, {}));
  Tracked tracked{.result = vo::track_sequence(sequence, options, {}, watched.observer(observer),
                                               bar.callback()),
                  .options = vo::fields_of(options)};
  tracked.log = vo::format_frame_log(tracked.result.frames);
  tracked.note = vo::note_on(tracked.result);
  tracked.sequence_notes = sequence.notes();
  write_results(arguments, tracked);
  write_map(arguments, cloud);
  if (arguments.debug_images > 0) {
    panels.commit();
    write_pictures(arguments, sequence, tracked.result);
  }
  bar.erase();
  const int status = print(arguments, tracked, session);
  watched.finish(vo::concat(tracked.result.trajectory.size(), " of ", tracked.result.frames.size(),
                            " frames tracked"));
  return status;
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
  const Tracked tracked{.result = result.tracking(),
                        .options = vo::fields_of(options),
                        .log = vo::format_mono_log(result.frames),
                        .mono = &result,
                        .note = note_on(result, options.bootstrap),
                        .sequence_notes = result.sequence_notes};
  write_results(arguments, tracked);
  write_map(arguments, cloud);
  bar.erase();
  const int status = print(arguments, tracked, session);
  watched.finish(vo::concat(tracked.result.trajectory.size(), " of ", tracked.result.frames.size(),
                            " frames tracked"));
  return status;
}

int track(TrackArguments& arguments, const Session& session) {
  read_config(arguments);
  const std::optional<vo::RgbdCamera> camera = given_camera(arguments.camera);
  vo::require_writable(arguments.out);
  if (!arguments.frame_log.empty()) {
    vo::require_writable(arguments.frame_log);
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
  command.add_option("SEQUENCE", arguments->sequence, "folder of a sequence, recording or video")
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
  command.add_option("--save-map", arguments->save_map,
                     "points of all keyframes with the sigma of each inverse depth, .ply or .pcd");
  command
      .add_option("--debug-images", arguments->debug_images,
                  "a picture of every N-th frame and the trajectory, beside --out")
      ->check(CLI::PositiveNumber);
  command.add_option("--max-time-difference", arguments->max_time_difference,
                     "between the stamps of colour and depth, s [0.02]");
  add_topic_options(command, arguments->topics);
  add_live_options(command, arguments->live);
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"--camera", "--config", "--depth-file"},
                         .outputs = {"--out", "--frame-log"},
                         .others = {"SEQUENCE", "--save-map"}});
  command.callback([arguments, &session] { session.status = track(*arguments, session); });
}

}  // namespace tools
