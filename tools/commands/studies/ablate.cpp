#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synth/sequence/render_sequence.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/commands/studies/study_commands.h"
#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "tools/studies/pose_pairs.h"
#include "tools/studies/study.h"
#include "vo/core/error.h"
#include "vo/files/result_files.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAblateHelp =
    "Repeats the experiments of the paper (Christensen & Hebert, Edge-Direct Visual Odometry) on "
    "a\n"
    "sequence with ground truth or on a scenario, which is rendered into DIR/sequence first:\n"
    "  points     edges, as many random pixels, all pixels, over the share of them kept (Figure "
    "8)\n"
    "  detectors  edge detectors, frame to frame and with keyframes (Table 1)\n"
    "  residuals  residuals of all pixels before and after aligning edges only (Figure 4)\n"
    "  levels     depth of the pyramid against convergence from identity (Figure 3)\n"
    "  time       time of an alignment against its number of points, with a linear fit\n"
    "  mono       one change at a time of how a monocular depth map is kept (docs/mono.md)\n"
    "  pairs      random pairs of views of a glTF scene: accuracy and basin of convergence\n"
    "  stress     the sequence as recorded, turned, reversed, halved, and with faults: frozen,\n"
    "             covered, a thing moving through, depth mirrored, stale or bent; what is said\n"
    "Writes DIR/STUDY.csv, .svg and .md and prints the table. Columns in ms differ from run to "
    "run:\n"
    "to measure again into the same DIR, --force.";

constexpr const char* kAblateExamples =
    "Examples:\n"
    "  edvo ablate scenarios/room_orbit.toml --study points --out ablation\n"
    "  edvo ablate rgbd_dataset_freiburg1_xyz --camera tum-fr1 --study levels \\\n"
    "       --max-error 0.02 --max-error-deg 1 --out ablation\n"
    "  edvo ablate scenarios/mono_sideways.toml --mono --out ablation\n"
    "  edvo ablate --pairs --preset default --out ablation    # of assets/room/room.gltf";

struct AblateArguments {
  CommonOptions common;
  std::string input;
  std::string study;
  bool pairs = false;
  bool mono = false;
  std::string camera;
  std::string preset_name = "paper";
  std::vector<std::string> assignments;
  std::string name;
  std::size_t max_frames = 0;
  StudySettings settings;
  std::string out;
};

std::vector<std::string> study_names() {
  std::vector<std::string> names;
  for (const auto& [name, study] : kStudies) {
    names.emplace_back(name);
  }
  return names;
}

void complete(AblateArguments& arguments) {
  constexpr const char* kOurRoom = "assets/room/room.gltf";
  for (const auto& [is_set, name] :
       {std::pair{arguments.pairs, "pairs"}, std::pair{arguments.mono, "mono"}}) {
    if (is_set && !arguments.study.empty() && arguments.study != name) {
      vo::fail_as(vo::ErrorKind::usage, "--", name, ": cannot be together with --study ",
                  arguments.study);
    }
    arguments.study = is_set ? name : arguments.study;
  }
  if (arguments.input.empty() && arguments.study == "pairs") {
    arguments.input = kOurRoom;
  }
  if (arguments.input.empty() || arguments.study.empty()) {
    vo::fail_as(vo::ErrorKind::usage,
                "ablate: expected INPUT and --study NAME or --mono, or --pairs");
  }
  StudySettings& settings = arguments.settings;
  settings.preset = vo::parse_enum<vo::TrackerPreset>(arguments.preset_name);
  settings.assignments = split_assignments(arguments.assignments);
  check_usage([&] {
    settings.validate();
    if (arguments.study == "mono") {
      settings.mono_options({});
    } else {
      settings.options({}, {});
    }
  });
}

/// Renders a sequence into a folder of this name in --out and returns its path.
fs::path rendered(const AblateArguments& arguments, const synth::RenderJob& job, const char* name) {
  fs::path folder = fs::path(arguments.out) / name;
  ProgressBar bar("rendering", arguments.common.verbosity());
  bar.announce();
  synth::render_sequence(job, folder, arguments.common.output_policy(), bar.callback());
  return folder;
}

fs::path sequence_folder(const AblateArguments& arguments) {
  const fs::path input = arguments.input;
  if (arguments.study == "pairs") {
    return rendered(arguments, pose_pairs_job(input), "pairs");
  }
  return names_scenario(input) ? rendered(arguments, render_job(load_scenario(input)), "sequence")
                               : input;
}

std::string clip_name(const AblateArguments& arguments) {
  if (!arguments.name.empty()) {
    return arguments.name;
  }
  const fs::path input = arguments.input;
  return (input.has_filename() ? input : input.parent_path()).stem().string();
}

Clip load(const AblateArguments& arguments) {
  const std::optional<vo::RgbdCamera> camera = given_camera(arguments.camera);
  const fs::path folder = sequence_folder(arguments);
  ProgressBar bar("reading", arguments.common.verbosity());
  bar.announce();
  const vo::SequenceReader sequence(folder, camera);
  return load_clip(sequence, clip_name(arguments), arguments.max_frames, bar.callback());
}

/// Returns the command that repeats the report, without file locations.
std::string command_line(const AblateArguments& arguments) {
  std::string text = "edvo ablate " + fs::path(arguments.input).filename().string();
  text += arguments.camera.empty() ? "" : " --camera " + arguments.camera;
  text += arguments.name.empty() ? "" : " --name '" + arguments.name + "'";
  text += " --study " + arguments.study;
  text += arguments.study == "mono" ? "" : " --preset " + arguments.preset_name;
  text += format_assignments(arguments.assignments);
  const StudySettings defaults;
  const StudySettings& settings = arguments.settings;
  text += arguments.max_frames > 0 ? vo::concat(" --max-frames ", arguments.max_frames) : "";
  text += settings.seeds != defaults.seeds ? vo::concat(" --seeds ", settings.seeds) : "";
  if (settings.max_error != defaults.max_error ||
      settings.max_error_deg != defaults.max_error_deg) {
    text += vo::concat(" --max-error ", settings.max_error, " --max-error-deg ",
                       settings.max_error_deg);
  }
  return text + " --out DIR";
}

void ablate(AblateArguments& arguments) {
  const auto limit = arguments.common.limit_threads();
  complete(arguments);
  const auto* study = std::find_if(kStudies.begin(), kStudies.end(), [&](const auto& known) {
    return known.first == arguments.study;
  });
  const vo::FolderForResults folder(arguments.out);
  const Clip clip = load(arguments);
  ProgressBar bar(arguments.study, arguments.common.verbosity());
  bar.announce();
  const StudyReport report = study->second(clip, arguments.settings, bar.callback());
  bar.erase();
  deliver_study(report, command_line(arguments), arguments.out, arguments.common);
}

}  // namespace

void add_ablate_command(CLI::App& program, Session& /*session*/) {
  CLI::App& command = *program.add_subcommand("ablate", kAblateHelp);
  const auto arguments = std::make_shared<AblateArguments>();
  command.footer(kAblateExamples);
  command.add_option("INPUT", arguments->input,
                     "sequence folder or scenario .toml; for pairs a glTF scene");
  command.add_option("--study", arguments->study, "what to measure, one of those above")
      ->check(CLI::IsMember(study_names()));
  command.add_flag("--pairs", arguments->pairs, "--study pairs");
  command.add_flag("--mono", arguments->mono, "--study mono; --set then takes its keys");
  command.add_option("--out", arguments->out, "folder for all results")->required();
  add_camera_option(command, arguments->camera);
  command.add_option("--preset", arguments->preset_name, "paper | default [paper]")
      ->check(CLI::IsMember({"paper", "default"}));
  command
      .add_option("--set", arguments->assignments,
                  "key=value of the tracker's options, may be repeated (edvo track --help)")
      ->allow_extra_args(false);
  command.add_option("--name", arguments->name, "of the input in titles [its file name]");
  command.add_option("--seeds", arguments->settings.seeds, "repetitions of what is random [5]");
  command.add_option("--max-frames", arguments->max_frames, "frames used at most; 0 = all [0]");
  command.add_option("--max-error", arguments->settings.max_error,
                     "of an alignment that converged (levels, pairs), m [0.005]");
  command.add_option("--max-error-deg", arguments->settings.max_error_deg,
                     "of an alignment that converged (levels, pairs), deg [0.15]");
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"INPUT"}, .configurations = {"--camera"}, .others = {"--out"}});
  command.callback([arguments] { ablate(*arguments); });
}

}  // namespace tools
