#include "tools/cameras/record.h"

#include <iostream>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "tools/cameras/live_camera.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr const char* kRecordHelp =
    "Writes what a camera sees as a sequence that every command reads: rgb/, depth/ (16 bit),\n"
    "rgb.txt, depth.txt and camera.toml, as TUM RGB-D has them. CAMERA is\n"
    "  openni2       the first camera of OpenNI2 (Kinect, Xtion, Structure, Orbbec)\n"
    "  openni2:URI   another one\n"
    "  v4l2          /dev/video0, a camera of Linux without depth, for --mode mono; it needs\n"
    "                --camera\n"
    "  v4l2:DEVICE   another one\n"
    "Depth is registered to colour and both are taken together where the device can. Ctrl-C ends\n"
    "the recording and keeps it.";

constexpr const char* kRecordExamples =
    "Examples:\n"
    "  edvo record openni2 desk                      # until Ctrl-C\n"
    "  edvo record openni2 desk --frames 300 --size 640x480 --camera my_camera.toml\n"
    "  edvo track desk --out desk.txt\n"
    "  edvo record v4l2:/dev/video1 walk --camera my_camera.toml\n"
    "  edvo track walk --mode mono --out walk.txt";

struct RecordArguments {
  CommonOptions common;
  std::string device;
  std::string out;
  std::string camera;
  std::string size;
  std::size_t frames = 0;
  double max_time_difference = 0.02;
};

LiveCameraSettings chosen_settings(const RecordArguments& arguments) {
  LiveCameraSettings settings{.camera = given_camera(arguments.camera),
                              .max_time_difference = arguments.max_time_difference};
  if (!arguments.size.empty()) {
    settings.size = parse_size(arguments.size);
  }
  return settings;
}

void print(const RecordArguments& arguments, const LiveCamera& camera, const RecordOutcome& outcome,
           const Colours& colours) {
  if (arguments.common.json) {
    const nlohmann::ordered_json result = {
        {"out", arguments.out},     {"device", camera.device},          {"frames", outcome.frames},
        {"missed", outcome.missed}, {"duration_s", outcome.duration_s}, {"notes", camera.notes}};
    std::cout << json_text(json_document({"record"}, result));
    return;
  }
  std::cout << arguments.out << ": " << outcome.frames << " frames in " << outcome.duration_s
            << " s of " << camera.device << ", " << outcome.missed << " missed\n"
            << note_lines(camera.notes, colours);
}

void record(const RecordArguments& arguments, const Session& session) {
  const LiveCameraSettings settings = chosen_settings(arguments);
  ProgressBar bar("recording", arguments.common.verbosity());
  bar.announce("opening " + arguments.device);
  const LiveCamera camera = open_live_camera(arguments.device, settings);
  const RecordOutcome outcome = record(
      camera, {.out = arguments.out, .frames = arguments.frames}, arguments.common.output_policy(),
      {.is_stopped = is_interrupted, .on_frame = [&](std::size_t frames) {
         bar.announce(vo::concat("recording ", camera.device, ", ", frames, " frames"));
       }});
  bar.erase();
  print(arguments, camera, outcome, session.out);
}

}  // namespace

void add_record_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("record", kRecordHelp);
  const auto arguments = std::make_shared<RecordArguments>();
  command.footer(kRecordExamples);
  command.add_option("CAMERA", arguments->device, "openni2, openni2:URI, v4l2 or v4l2:DEVICE")
      ->required();
  command.add_option("OUT", arguments->out, "folder to make")->required();
  command.add_option("--frames", arguments->frames, "at most so many; 0 is until Ctrl-C [0]");
  command.add_option("--camera", arguments->camera,
                     "preset or FILE.toml, in the place of what the device says of its lens");
  command.add_option("--size", arguments->size,
                     "WxH, px [openni2: the largest of at least 25 Hz; v4l2: that of --camera]");
  add_time_difference_option(command, arguments->max_time_difference,
                             "the stamps of colour and depth");
  add_common_options(command, arguments->common);
  take_streams(command, {.configurations = {"--camera"}, .read = {"CAMERA"}, .written = {"OUT"}});
  command.callback([arguments, &session] { record(*arguments, session); });
}

}  // namespace tools
