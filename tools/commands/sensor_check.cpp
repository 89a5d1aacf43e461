#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "synth/path_planning/path_options.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
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

constexpr int kMostFrames = 100'000;

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

/// Returns the camera of the contact sheet. Throws vo::Error of kind usage for an impossible size.
vo::PinholeCamera sheet_camera(const SensorCheckArguments& arguments) {
  const auto [width, height] = parse_size(arguments.size);
  try {
    require_sheet_size(width, height);
  } catch (const vo::Error& error) {
    vo::fail_as(vo::ErrorKind::usage, "--size ", arguments.size, ": ", error.what());
  }
  return vo::PinholeCamera::from_horizontal_fov(width, height, arguments.fov_deg);
}

void print(const SensorCheckArguments& arguments, double depth, double image) {
  if (arguments.common.json) {
    std::cout << json_text(
        json_document({"sensor_check"}, {{"out", arguments.out},
                                         {"worst_depth_deviation_share", depth},
                                         {"worst_image_deviation_share", image}}));
    return;
  }
  std::cout << std::fixed << std::setprecision(1)  //
            << arguments.out << ": measured deviations are at most " << 100 * depth
            << " % (depth) and " << 100 * image << " % (image) off their formulas\n";
}

void sensor_check(const SensorCheckArguments& arguments) {
  const auto limit = arguments.common.limit_threads();
  check_usage([&] { arguments.path.validate(); });
  const vo::PinholeCamera camera = sheet_camera(arguments);
  ProgressBar bar("measuring", arguments.common.verbosity());
  bar.announce("measuring the noise of depth");
  const std::vector<NoiseSample> depth = measure_noise(arguments.frames, bar.callback());
  bar.announce("measuring the noise of images");
  const std::vector<GreyNoise> image = measure_grey_noise();
  std::vector<vo::NamedBytes> files = {{"depth_noise.csv", format_noise_csv(depth)},
                                       {"image_noise.csv", format_grey_csv(image)},
                                       {"noise.svg", plot_noise(depth, image)}};
  if (!arguments.scene.empty()) {
    bar.announce("rendering " + arguments.scene);
    files.push_back(
        {"contact_sheet.webp", contact_sheet(arguments.scene, {.samples = arguments.samples},
                                             camera, arguments.path, bar.callback("rendering"))});
  }
  vo::make_folder(arguments.out);
  vo::write_results(arguments.out, files, arguments.common.output_policy());
  bar.erase();
  print(arguments, worst_share(depth), worst_share(image));
}

}  // namespace

void add_sensor_check_command(CLI::App& program, Session& /*session*/) {
  CLI::App& command = *program.add_subcommand("sensor-check", kSensorCheckHelp);
  const auto arguments = std::make_shared<SensorCheckArguments>();
  arguments->path.duration = 1;
  command.footer(kSensorCheckExamples);
  command.add_option("--out", arguments->out, "folder for the results")->required();
  command.add_option("--frames", arguments->frames, "noise images per depth and angle [20]")
      ->check(from_one_to(kMostFrames));
  command.add_option("--scene", arguments->scene, "glTF file of the contact sheet")
      ->group("Contact sheet");
  command.add_option("--size", arguments->size, "WIDTHxHEIGHT, px [320x240]")
      ->group("Contact sheet");
  command.add_option("--fov", arguments->fov_deg, "horizontal, deg [62]")->group("Contact sheet");
  command.add_option("--samples", arguments->samples, "colour samples per pixel [16]")
      ->group("Contact sheet");
  add_field_options(command, vo::fields_of(arguments->path, "path."), "Contact sheet");
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"--scene"}, .others = {"--out"}});
  command.callback([arguments] { sensor_check(*arguments); });
}

}  // namespace tools
