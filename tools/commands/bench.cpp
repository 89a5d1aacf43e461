#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/bench/bench_report.h"
#include "tools/bench/frames.h"
#include "tools/bench/growth.h"
#include "tools/bench/peer.h"
#include "tools/bench/race.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "vo/dataset/sequence.h"
#include "vo/files/output.h"

namespace tools {
namespace {

constexpr const char* kBenchHelp =
    "Times the tracker, one thread, on frames that are in memory: ms per frame, by stage, of our\n"
    "presets and of others that do the same, each beside the errors it makes. All run in turn in\n"
    "one process, so the ratios hold on a busy machine where the times do not.";

constexpr const char* kBenchExamples =
    "Columns: median and 90th percentile of a frame; its CPU time, which is the same on an idle\n"
    "machine and which the ratios are of; medians of its stages (`map`: keeping frames for later\n"
    "ones, for mono the depth map); points of the finest level; MiB of all keyframes after the "
    "last frame; RPE over 1 s; "
    "ATE.\n"
    "`ns for each` is of a whole frame: all iterations, all levels.\n\n"
    "Examples:\n"
    "  edvo bench rgbd_dataset_freiburg1_xyz --camera tum-fr1\n"
    "  edvo bench scenarios/room_orbit.toml --frames 60 --peers edvo,opencv-rgbd\n"
    "  edvo bench sequence --peers edvo --set align.threads=2 --set map.references=3\n"
    "  edvo bench sequence --peers edvo --growth --json --out bench.json";

struct BenchArguments {
  CommonOptions common;
  std::string input;
  std::string camera;
  int frames = 100;
  RaceOptions race;
  std::vector<std::string> peers = peer_names();
  std::vector<std::string> assignments;  ///< key=value of one more row of preset default
  bool growth = false;
  std::string out;
};

/// Loads the frames, or renders those of a scenario.
Frames load_input(const BenchArguments& arguments) {
  const auto count = static_cast<std::size_t>(arguments.frames);
  ProgressBar loading("loading", arguments.common.verbosity());
  loading.announce();
  if (!names_scenario(arguments.input)) {
    return load_frames(vo::SequenceReader(arguments.input, given_camera(arguments.camera)), count,
                       loading.callback());
  }
  if (!arguments.camera.empty()) {
    vo::fail_as(vo::ErrorKind::usage, "--camera: a scenario has its own camera");
  }
  const auto limit = arguments.common.limit_threads();
  ProgressBar rendering("rendering", arguments.common.verbosity());
  rendering.announce();
  return render_frames(render_job(load_scenario(arguments.input)), count, rendering.callback(),
                       loading.callback());
}

BenchReport measure(const BenchArguments& arguments, const Frames& input) {
  ProgressBar racing("racing", arguments.common.verbosity());
  racing.announce();
  const vo::TrackerOptions options = default_with(split_assignments(arguments.assignments));
  LineUp line = line_up(arguments.peers);
  if (!arguments.assignments.empty()) {
    line.peers.push_back(edvo_peer("default-set", options));
  }
  BenchReport report =
      race_peers(arguments.input, input, std::move(line), arguments.race, racing.callback());
  if (arguments.growth) {
    ProgressBar growing("growing", arguments.common.verbosity());
    growing.announce();
    report.growth = measure_growth(input, options, arguments.race, growing.callback());
  }
  return report;
}

void bench(const BenchArguments& arguments, const Session& session) {
  check_usage([&] {
    arguments.race.validate();
    default_with(split_assignments(arguments.assignments));
  });
  if (!arguments.out.empty()) {
    vo::require_writable(arguments.out);
  }
  const BenchReport report = measure(arguments, load_input(arguments));
  const std::string json = json_text(bench_json(report));
  if (!arguments.out.empty()) {
    vo::write_file(arguments.out, json, arguments.common.output_policy());
  }
  speech_beside(session, {arguments.out}).stream
      << (arguments.common.json ? json : bench_table(report));
}

}  // namespace

void add_bench_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("bench", kBenchHelp);
  const auto arguments = std::make_shared<BenchArguments>();
  command.footer(kBenchExamples);
  command.add_option("INPUT", arguments->input, "sequence folder, or scenario .toml")->required();
  add_camera_option(command, arguments->camera);
  command.add_option("--frames", arguments->frames, "the first N; all are held in memory [100]")
      ->check(at_least_one());
  command
      .add_option("--repeat", arguments->race.repeats,
                  "of the whole; a frame's time is the median [3]")
      ->check(at_least_one());
  command.add_option("--peers", arguments->peers, "who runs, with commas between [all]")
      ->delimiter(',')
      ->check(CLI::IsMember(peer_names()));
  command.add_option(
      "--set", arguments->assignments,
      "key=value as of `edvo track`, may be repeated: one more row, default-set, is\n"
      "preset default with these values, and what --growth starts from");
  command.add_flag("--growth", arguments->growth,
                   "also how preset default's time grows with points, levels and resolution");
  command.add_option("--out", arguments->out, "the result as JSON, also to this file");
  add_common_options(command, arguments->common);
  take_streams(command,
               {.inputs = {"INPUT"}, .configurations = {"--camera"}, .outputs = {"--out"}});
  command.callback([arguments, &session] { bench(*arguments, session); });
}

}  // namespace tools
