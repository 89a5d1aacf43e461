#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include "synth/camera/sequence_camera.h"
#include "synth/gltf/gltf.h"
#include "synth/path_planning/path_options.h"
#include "tools/cli/options.h"
#include "tools/commands/commands.h"
#include "tools/pictures/webp.h"
#include "tools/sensor_check/contact_sheet.h"
#include "tools/sensor_check/noise_table.h"
#include "vo/core/error.h"
#include "vo/files/result_files.h"

namespace tools {
namespace {

constexpr const char* kSensorCheckHelp =
    "Measures the noise of the sensor presets on planes and greys and compares it with their\n"
    "formulas: depth_noise.csv, image_noise.csv and noise.svg. With --scene also "
    "contact_sheet.webp:\n"
    "one frame of a path as each preset takes it.";

constexpr const char* kSensorCheckExamples =
    "Examples:\n"
    "  edvo sensor-check --out check\n"
    "  edvo sensor-check --scene assets/room/room.gltf --path.orbit.centre -0.95,0.5,0.3 \\\n"
    "       --path.orbit.radius 1.2 --path.orbit.height 0.8 --path.orbit.period 7.5 --out check";

struct SensorCheckArguments {
  CommonOptions common;
  std::string scene;
  std::string size = "320x240";
  double fov_deg = 62;
  int samples = 16;
  int frames = 20;
  synth::PathOptions path;
  std::string out;
};

/// Returns the greatest relative difference of a measured deviation from its formula.
double worst_share(const std::vector<NoiseSample>& samples) {
  double worst = 0;
  for (const NoiseSample& sample : samples) {
    worst = std::max(worst, std::abs(sample.measured.deviation / sample.formula.deviation - 1));
  }
  return worst;
}

double worst_share(const std::vector<GreyNoise>& samples) {
  double worst = 0;
  for (const GreyNoise& sample : samples) {
    worst = std::max(worst, std::abs(sample.measured / sample.formula - 1));
  }
  return worst;
}

std::string contact_sheet(const SensorCheckArguments& arguments) {
  const synth::SceneFile file(arguments.scene);
  const synth::Scene& scene = file.scene();
  const synth::RenderersOverTime renderers(scene, {.samples = arguments.samples});
  const auto [width, height] = parse_size(arguments.size);
  const synth::TimedPath timed = synth::make_path(arguments.path, file);
  const synth::CameraTruth motion{synth::sample(timed.path, timed.times), timed.path};
  const auto camera = vo::PinholeCamera::from_horizontal_fov(width, height, arguments.fov_deg);
  constexpr double kQuality = 88;  // of 100; noise makes lossless files five times as large
  return encode_webp(draw_contact_sheet(scene, renderers, camera, motion, motion.truth.size() / 2),
                     kQuality);
}

void print(const SensorCheckArguments& arguments, double depth, double image) {
  if (arguments.common.json) {
    std::cout << nlohmann::ordered_json{{"out", arguments.out},
                                        {"worst_depth_deviation_share", depth},
                                        {"worst_image_deviation_share", image}}
                     .dump(2)
              << "\n";
    return;
  }
  std::cout << std::fixed << std::setprecision(1)  //
            << arguments.out << ": measured deviations are at most " << 100 * depth
            << " % (depth) and " << 100 * image << " % (image) off their formulas\n";
}

void sensor_check(const SensorCheckArguments& arguments) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  arguments.common.max_threads());
  check_usage([&] { arguments.path.validate(); });
  const std::vector<NoiseSample> depth = measure_noise(arguments.frames);
  const std::vector<GreyNoise> image = measure_grey_noise();
  std::vector<vo::NamedBytes> files = {{"depth_noise.csv", format_noise_csv(depth)},
                                       {"image_noise.csv", format_grey_csv(image)},
                                       {"noise.svg", plot_noise(depth, image)}};
  if (!arguments.scene.empty()) {
    files.push_back({"contact_sheet.webp", contact_sheet(arguments)});
  }
  vo::make_folder(arguments.out);
  vo::write_results(arguments.out, files, arguments.common.existing());
  print(arguments, worst_share(depth), worst_share(image));
}

}  // namespace

void add_sensor_check_command(CLI::App& program, int& /*exit_code*/) {
  CLI::App& command = *program.add_subcommand("sensor-check", kSensorCheckHelp);
  const auto arguments = std::make_shared<SensorCheckArguments>();
  arguments->path.duration = 1;
  command.footer(kSensorCheckExamples);
  command.add_option("--out", arguments->out, "folder for the results")->required();
  command.add_option("--frames", arguments->frames, "noise images per depth and angle [20]")
      ->check(CLI::PositiveNumber);
  command.add_option("--scene", arguments->scene, "glTF file of the contact sheet")
      ->group("Contact sheet");
  command.add_option("--size", arguments->size, "WIDTHxHEIGHT, px [320x240]")
      ->group("Contact sheet");
  command.add_option("--fov", arguments->fov_deg, "horizontal, deg [62]")->group("Contact sheet");
  command.add_option("--samples", arguments->samples, "colour samples per pixel [16]")
      ->group("Contact sheet");
  add_field_options(command, vo::fields_of(arguments->path, "path."), "Contact sheet");
  add_common_options(command, arguments->common);
  command.callback([arguments] { sensor_check(*arguments); });
}

}  // namespace tools
