#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include "synth/sequence/render_sequence.h"
#include "tools/bench/bench_report.h"
#include "tools/bench/frames.h"
#include "tools/bench/growth.h"
#include "tools/bench/peer.h"
#include "tools/bench/race.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/commands/commands.h"
#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/sequence.h"
#include "vo/files/output.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

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
    "  edvo bench sequence --peers edvo --growth --json --out bench.json";

struct BenchArguments {
  CommonOptions common;
  std::string input;
  std::string camera;
  int frames = 100;
  RaceOptions race;
  std::vector<std::string> peers = peer_names();
  bool growth = false;
  std::string out;
};

Frames load_sequence(const BenchArguments& arguments, const fs::path& folder) {
  std::optional<vo::RgbdCamera> camera;
  if (!arguments.camera.empty()) {
    camera = vo::load_camera(arguments.camera);
  }
  ProgressBar bar("loading", arguments.common.verbosity());
  return load_frames(vo::SequenceReader(folder, camera), static_cast<std::size_t>(arguments.frames),
                     bar.callback());
}

/// Renders the requested number of frames into a temporary folder and returns them.
Frames render_scenario(const BenchArguments& arguments) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  arguments.common.max_threads());
  synth::RenderJob job = render_job(load_scenario(arguments.input));
  vo::Trajectory& truth = job.recipe.truth;
  truth.resize(std::min(truth.size(), static_cast<std::size_t>(arguments.frames)));
  const vo::OutputFolder scratch(fs::temp_directory_path() / "edvo-bench", "sequence.toml",
                                 vo::ExistingOutput::keep);
  ProgressBar bar("rendering", arguments.common.verbosity());
  const fs::path folder = scratch.partial() / "sequence";
  synth::render_sequence(job, folder, vo::ExistingOutput::keep, bar.callback());
  return load_sequence(arguments, folder);
}

Frames load_input(const BenchArguments& arguments) {
  const bool is_scenario = fs::path(arguments.input).extension() == ".toml";
  if (is_scenario && !arguments.camera.empty()) {
    vo::fail_as(vo::ErrorKind::usage, "--camera: a scenario has its own camera");
  }
  return is_scenario ? render_scenario(arguments) : load_sequence(arguments, arguments.input);
}

BenchReport measure(const BenchArguments& arguments, const Frames& input) {
  LineUp line = line_up(arguments.peers);
  BenchReport report{.input = arguments.input,
                     .cpu = cpu_model(),
                     .width = input.camera.width,
                     .height = input.camera.height,
                     .frames = input.frames.size(),
                     .options = arguments.race,
                     .absent = std::move(line.absent)};
  ProgressBar bar("racing", arguments.common.verbosity());
  for (const RaceResult& result : race(input, line.peers, arguments.race, bar.callback())) {
    report.peers.push_back(summarize(result, input, arguments.race));
  }
  if (arguments.growth) {
    ProgressBar growth_bar("growing", arguments.common.verbosity());
    report.growth = measure_growth(input, vo::preset_options(vo::TrackerPreset::best_measured),
                                   arguments.race, growth_bar.callback());
  }
  return report;
}

void bench(const BenchArguments& arguments) {
  check_usage([&] { arguments.race.validate(); });
  if (!arguments.out.empty()) {
    vo::require_writable(arguments.out);
  }
  const BenchReport report = measure(arguments, load_input(arguments));
  const std::string json = bench_json(report).dump(2) + "\n";
  if (!arguments.out.empty()) {
    vo::write_file(arguments.out, json, arguments.common.existing());
  }
  std::cout << (arguments.common.json ? json : bench_table(report));
}

}  // namespace

void add_bench_command(CLI::App& program, int& /*exit_code*/) {
  CLI::App& command = *program.add_subcommand("bench", kBenchHelp);
  const auto arguments = std::make_shared<BenchArguments>();
  command.footer(kBenchExamples);
  command.add_option("INPUT", arguments->input, "sequence folder, or scenario .toml")->required();
  command.add_option("--camera", arguments->camera,
                     "preset or FILE.toml; otherwise the sequence's camera.toml");
  command.add_option("--frames", arguments->frames, "the first N; all are held in memory [100]")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--repeat", arguments->race.repeats,
                  "of the whole; a frame's time is the median [3]")
      ->check(CLI::PositiveNumber);
  command.add_option("--peers", arguments->peers, "who runs, with commas between [all]")
      ->delimiter(',')
      ->check(CLI::IsMember(peer_names()));
  command.add_flag("--growth", arguments->growth,
                   "also how preset default's time grows with points, levels and resolution");
  command.add_option("--out", arguments->out, "the result as JSON, also to this file");
  add_common_options(command, arguments->common);
  command.callback([arguments] { bench(*arguments); });
}

}  // namespace tools
