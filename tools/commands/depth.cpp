#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/cli/exit_code.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/topic_arguments.h"
#include "tools/commands/commands.h"
#include "tools/depth/depth_output.h"
#include "tools/depth/depth_table.h"
#include "tools/depth/mapping_run.h"
#include "tools/depth/mono_run.h"
#include "tools/json/document.h"
#include "tools/plot/table.h"
#include "tools/report/report.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr const char* kDepthHelp =
    "Monocular mapping alone: keeps an inverse-depth map over edge pixels with the sequence's\n"
    "ground-truth poses, or with those and noise, and compares it with the true depth. Depth\n"
    "images are read to judge, and to start from where start=rgbd.\n"
    "With --track the poses are the monocular tracker's own, as in `edvo track --mode mono`, and\n"
    "--set takes that command's keys; without a metric bootstrap the median scale is taken out.";

struct DepthArguments {
  CommonOptions common;
  std::string sequence;
  std::string camera;
  std::vector<std::string> assignments;
  std::string out;
  bool track = false;
  std::string bootstrap = "auto";
  std::string depth_file;
  int every = 20;
  double max_time_difference = 0.02;
  vo::SequenceTopics topics;  ///< of a recording
  double depth_noise = 0;
};

std::string examples() {
  MappingOptions options;
  return "Examples:\n"
         "  edvo depth sequence\n"
         "  edvo depth sequence --out maps --every 10   # maps/depth.csv, 000010.png, cloud.ply\n"
         "  edvo depth sequence --set pose_noise_m=0.002 --set map.propagate=always --json\n"
         "  edvo depth sequence --track --bootstrap rgbd --out maps\n"
         "  edvo depth recording --camera tum-fr1 --track --depth-noise 0.0019\n\n"
         "Keys of --set, with their values:\n" +
         describe_fields(vo::fields_of(options));
}

/// Returns the options with the command line's assignments applied.
template <typename Options>
Options assigned(const DepthArguments& arguments, Options options, const Colours& colours) {
  std::vector<vo::Field> fields = vo::fields_of(options);
  for (const std::string& assignment : arguments.assignments) {
    apply_assignment(assignment, fields, colours);
  }
  return options;
}

MappingOptions mapping_options(const DepthArguments& arguments, const Colours& colours) {
  MappingOptions initial;
  initial.depth_noise = arguments.depth_noise;
  MappingOptions options = assigned(arguments, initial, colours);
  check_usage([&] { options.validate(); });
  return options;
}

vo::MonoOptions tracking_options(const DepthArguments& arguments, const Colours& colours) {
  vo::MonoOptions options = assigned(arguments, vo::mono_options(), colours);
  check_usage([&] {
    options.bootstrap = vo::parse_enum<vo::MonoBootstrap>(arguments.bootstrap);
    options.validate();
  });
  return options;
}

void print(const DepthArguments& arguments, const nlohmann::ordered_json& options,
           const std::vector<MappedFrame>& frames) {
  const MapErrors& last = frames.back().errors;
  if (arguments.common.json) {
    std::cout << json_text(json_document({"depth"}, {{"sequence", arguments.sequence},
                                                     {"frames", frames.size()},
                                                     {"density_percent", last.density_percent},
                                                     {"scale", last.scale},
                                                     {"first_scale", frames.front().errors.scale},
                                                     {"errors", as_json(error_table(last))},
                                                     {"mapping_ms", median_mapping_ms(frames)},
                                                     {"options", options}}));
    return;
  }
  std::cout << as_text(error_table(last)) << "after " << frames.size() << " frames; "
            << format_decimals(last.density_percent, 1)
            << " % of the edge pixels are confident, scale " << format_decimals(last.scale, 4)
            << " (at first " << format_decimals(frames.front().errors.scale, 4) << "), "
            << format_decimals(median_mapping_ms(frames), 2) << " ms per frame (median)\n";
}

int depth(const DepthArguments& arguments, const Session& session) {
  MappingOptions mapping;
  vo::MonoOptions tracking = vo::mono_options();
  if (arguments.track) {
    tracking = tracking_options(arguments, session.err);
  } else {
    mapping = mapping_options(arguments, session.err);
  }
  const std::optional<vo::RgbdCamera> camera = given_camera(arguments.camera);
  std::optional<DepthOutput> output;
  if (!arguments.out.empty()) {
    output.emplace(arguments.out, arguments.every, arguments.common.output_policy(),
                   throw_if_interrupted);
  }
  const auto observer = [&](MapScale scale) {
    return output ? output->observer(scale) : MapObserver();
  };
  ProgressBar bar("mapping", arguments.common.verbosity());
  bar.announce("reading " + arguments.sequence);
  std::vector<MappedFrame> frames;
  if (arguments.track) {
    frames = track_and_judge(
        {arguments.sequence, camera, arguments.max_time_difference, arguments.depth_file,
         arguments.topics},
        tracking, arguments.depth_noise,
        observer(is_metric(tracking.bootstrap) ? MapScale::metric : MapScale::arbitrary),
        bar.callback());
  } else {
    const vo::SequenceReader sequence(arguments.sequence, camera, arguments.max_time_difference,
                                      vo::SequenceContent::colour_and_depth, arguments.topics);
    frames = map_sequence(sequence, mapping, observer(MapScale::metric), bar.callback());
  }
  vo::require(frames.size() > 1, arguments.sequence,
              ": expected at least two frames that can be mapped and judged, found ",
              frames.size());
  if (output) {
    output->commit(frames);
  }
  bar.erase();
  print(arguments, fields_json(arguments.track ? vo::fields_of(tracking) : vo::fields_of(mapping)),
        frames);
  return exit_code::kOk;
}

}  // namespace

void add_depth_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("depth", kDepthHelp);
  const auto arguments = std::make_shared<DepthArguments>();
  command.footer(examples());
  command
      .add_option("SEQUENCE", arguments->sequence,
                  "folder with rgb.txt, depth.txt, groundtruth.txt")
      ->required();
  command.add_option(
      "--out", arguments->out,
      "folder to make: depth.csv, pictures, cloud.ply and .pcd (the last pictured map)");
  command.add_flag("--track", arguments->track, "poses of the monocular tracker, not the truth");
  command
      .add_option("--bootstrap", arguments->bootstrap,
                  "with --track: rgbd | file | flat | random | auto [auto]")
      ->check(is_name_of<vo::MonoBootstrap>());
  command.add_option("--depth-file", arguments->depth_file,
                     "with --bootstrap file: depth of the first image");
  command.add_option("--every", arguments->every, "frames from picture to picture [20]")
      ->check(at_least_one());
  add_camera_option(command, arguments->camera);
  command.add_option("--set", arguments->assignments, "key=value, may be repeated; keys below")
      ->allow_extra_args(false);
  add_time_difference_option(command, arguments->max_time_difference,
                             "the stamps of colour and depth");
  command
      .add_option("--depth-noise", arguments->depth_noise,
                  "of the sequence's depth, sigma / depth^2, 1/m: 0.0019 for a Kinect [0]")
      ->check(CLI::NonNegativeNumber);
  add_topic_options(command, arguments->topics);
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"--depth-file"},
                         .configurations = {"--camera"},
                         .read = {"SEQUENCE"},
                         .written = {"--out"}});
  command.callback([arguments, &session] { session.status = depth(*arguments, session); });
}

}  // namespace tools
