#include <iostream>
#include <memory>
#include <string>

#include "synth/gltf/gltf.h"
#include "tools/bench/render_bench.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/trajectory_arguments.h"
#include "tools/commands/commands.h"
#include "vo/motion_files/trajectory_file.h"

namespace tools {
namespace {

constexpr const char* kBenchRenderHelp =
    "CPU seconds that a frame of a scene costs: depth alone, base colour with 16 samples, direct\n"
    "light with shadows and 16 samples (one thread), the rasterizer with one (all its threads);\n"
    "frames per second by the clock on the wall; and how the cost grows with samples, resolution\n"
    "and triangles.";

constexpr const char* kBenchRenderExamples =
    "Examples:\n"
    "  edvo bench-render room.gltf\n"
    "  edvo bench-render house.gltf --trajectory poses.txt --size 640x480 --json";

struct BenchRenderArguments {
  CommonOptions common;
  std::string scene;
  std::string size = "640x480";
  std::string trajectory;
  TrajectoryArguments reading;
  double fov_deg = 60;
};

void bench_render(const BenchRenderArguments& arguments) {
  const auto [width, height] = parse_size(arguments.size);
  const vo::PinholeCamera camera =
      vo::PinholeCamera::from_horizontal_fov(width, height, arguments.fov_deg);
  ProgressBar bar("measuring", arguments.common.verbosity());
  bar.announce("reading " + arguments.scene);
  const synth::Scene scene = synth::load_gltf(arguments.scene);
  const vo::Trajectory views =
      arguments.trajectory.empty()
          ? views_from_the_middle(scene)
          : vo::read_trajectory_file(arguments.trajectory, chosen_reading(arguments.reading))
                .trajectory;
  vo::require(!views.empty(), arguments.trajectory, ": no poses, expected at least one");
  bar.announce();
  const RenderBench bench = bench_rendering(scene, camera, views);
  bar.erase();
  std::cout << (arguments.common.json ? format_json(bench) : format_table(bench));
}

}  // namespace

void add_bench_render_command(CLI::App& program, Session& /*session*/) {
  CLI::App& command = *program.add_subcommand("bench-render", kBenchRenderHelp);
  const auto arguments = std::make_shared<BenchRenderArguments>();
  command.footer(kBenchRenderExamples);
  command.add_option("SCENE", arguments->scene, "glTF 2.0 file, .gltf or .glb")->required();
  command.add_option("--size", arguments->size, "WIDTHxHEIGHT, px [640x480]");
  command.add_option("--fov", arguments->fov_deg, "horizontal, deg [60]");
  command.add_option("--trajectory", arguments->trajectory,
                     "trajectory of the views; else four from the middle of the scene");
  add_trajectory_options(command, arguments->reading);
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"SCENE", "--trajectory", "--times"}});
  command.callback([arguments] { bench_render(*arguments); });
}

}  // namespace tools
