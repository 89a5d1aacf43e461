#include <iostream>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/convert_sequence.h"

namespace tools {
namespace {

constexpr const char* kConvertHelp =
    "Writes a sequence in another format, its poses, camera and IMU included:\n"
    "  tum       rgb/, depth/ (16 bit), rgb.txt, depth.txt, groundtruth.txt, camera.toml,\n"
    "            imu.csv, imu.toml\n"
    "  euroc     mav0/cam0, imu0, state_groundtruth_estimate0 (ns, quaternion w first; at the\n"
    "            IMU's stamps if there is one, not the frames'), and mav0/depth0 (16 bit, "
    "planar),\n"
    "            which is ours\n"
    "  icl-nuim  scene_00_NNNN.png, .depth (text, m along the ray), .txt (POV-Ray's camera)\n"
    "  icl-tum   the \"TUM compatible\" form: rgb/N.png, depth/N.png, associations.txt,\n"
    "            *.gt.freiburg\n"
    "Both forms of ICL-NUIM have a camera with y up (fy < 0) in a left-handed world and no stamps\n"
    "(30 Hz): converting turns them round. Depth beyond 16 bit becomes 0 and is counted.";

constexpr const char* kConvertExamples =
    "Examples:\n"
    "  edvo convert sequence sequence_euroc --format euroc\n"
    "  edvo convert living_room_traj0 sequence --format tum";

struct ConvertArguments {
  CommonOptions common;
  std::string in;
  std::string out;
  std::string format;
  std::string from;
  std::string camera;
};

vo::ConvertJob chosen_job(const ConvertArguments& arguments) {
  vo::ConvertJob job{.in = arguments.in, .out = arguments.out};
  check_usage([&] {
    job.to = vo::parse_enum<vo::SequenceFormat>(arguments.format);
    if (!arguments.from.empty()) {
      job.from = vo::parse_enum<vo::SequenceFormat>(arguments.from);
    }
  });
  job.camera = given_camera(arguments.camera);
  return job;
}

void print(const ConvertArguments& arguments, const vo::ConvertOutcome& outcome,
           const Colours& colours) {
  if (arguments.common.json) {
    const nlohmann::ordered_json result = {{"out", arguments.out},
                                           {"from", vo::to_string(outcome.from)},
                                           {"format", arguments.format},
                                           {"frames", outcome.frames},
                                           {"poses", outcome.poses},
                                           {"imu_samples", outcome.imu_samples},
                                           {"depth_beyond_16_bit", outcome.depth_beyond_16_bit},
                                           {"notes", outcome.notes}};
    std::cout << json_text(json_document({"convert"}, result));
    return;
  }
  std::cout << arguments.out << ": " << outcome.frames << " frames, " << outcome.poses << " poses, "
            << outcome.imu_samples << " IMU samples\n";
  if (outcome.depth_beyond_16_bit > 0) {
    std::cout << outcome.depth_beyond_16_bit << " depth pixels beyond 16 bit became 0\n";
  }
  for (const std::string& note : outcome.notes) {
    std::cout << colours.paint(Tone::caution, "note") << "  " << note << "\n";
  }
}

}  // namespace

void add_convert_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("convert", kConvertHelp);
  const auto arguments = std::make_shared<ConvertArguments>();
  command.footer(kConvertExamples);
  command.add_option("IN", arguments->in, "folder of a sequence")->required();
  command.add_option("OUT", arguments->out, "folder to make")->required();
  command.add_option("--format", arguments->format, "tum | euroc | icl-nuim | icl-tum")->required();
  command.add_option("--from", arguments->from, "the format of IN, where it is not found out");
  command.add_option("--camera", arguments->camera, "preset or FILE.toml, instead of IN's own");
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"--camera"}, .others = {"IN", "OUT"}});
  command.callback([arguments, &session] {
    const vo::ConvertJob job = chosen_job(*arguments);
    ProgressBar bar("converting", arguments->common.verbosity());
    bar.announce("reading " + arguments->in);
    const vo::ConvertOutcome outcome =
        vo::convert_sequence(job, arguments->common.output_policy(), bar.callback());
    bar.erase();
    print(*arguments, outcome, session.out);
  });
}

}  // namespace tools
