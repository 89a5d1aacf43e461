#include "tools/studies/basin.h"

#include <memory>
#include <string>

#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/commands/studies/study_commands.h"
#include "vo/files/result_files.h"

namespace tools {
namespace {

constexpr const char* kBasinHelp =
    "Maps from how far off the truth an alignment finds it: pairs of a scenario's frames are\n"
    "aligned from the true pose moved and turned by growing offsets. Writes DIR/basin.csv, .svg\n"
    "(two heat maps: converged, median error) and .md.";

constexpr const char* kBasinExamples =
    "Example:\n"
    "  edvo basin scenarios/room_tour.toml --set odometry.tracker.pyramid.levels=2 --out basin";

struct BasinArguments {
  LaboratoryArguments lab;
  std::string scenario;
  BasinSettings settings;
};

std::string command_line(const BasinArguments& arguments) {
  std::string text = "edvo basin " + arguments.scenario;
  text += format_assignments(arguments.lab.assignments);
  const BasinSettings& settings = arguments.settings;
  return text + vo::concat(" --pairs ", settings.pairs, " --apart ", settings.apart, " --steps ",
                           settings.steps, " --max-translation ", settings.max_translation,
                           " --max-rotation-deg ", settings.max_rotation_deg, " --max-error ",
                           settings.max_error, " --max-error-deg ", settings.max_error_deg,
                           " --out DIR");
}

void basin(BasinArguments& arguments) {
  const auto limit = arguments.lab.common.limit_threads();
  arguments.lab.complete();
  const Scenario scenario =
      load_scenario(arguments.scenario, split_assignments(arguments.lab.assignments));
  vo::require(scenario.odometry.mode == OdometryMode::rgbd, arguments.scenario,
              ": odometry.mode is \"", vo::to_string(scenario.odometry.mode),
              "\", expected \"rgbd\": `edvo basin` aligns points of depth images");
  arguments.settings.tracker = scenario.odometry.tracker;
  arguments.settings.jobs = arguments.lab.run.jobs;
  check_usage([&] { arguments.settings.validate(); });
  const vo::FolderForResults folder(arguments.lab.out);
  ProgressBar rendering("rendering", arguments.lab.common.verbosity());
  rendering.announce();
  ProgressBar reading("reading", Verbosity::quiet);
  const Clip clip = load_clip(scenario, arguments.lab.run.trial.cache,
                              {rendering.callback(), reading.callback()});
  rendering.erase();
  ProgressBar aligning("aligning", arguments.lab.common.verbosity());
  aligning.announce();
  const StudyReport report = study_basin(clip, arguments.settings, aligning.callback());
  aligning.erase();
  deliver_study(report, command_line(arguments), arguments.lab.out, arguments.lab.common);
}

}  // namespace

void add_basin_command(CLI::App& program, Session& /*session*/) {
  CLI::App& command = *program.add_subcommand("basin", kBasinHelp);
  const auto arguments = std::make_shared<BasinArguments>();
  command.footer(kBasinExamples);
  command.add_option("SCENARIO", arguments->scenario, "scenario file, .toml")->required();
  command.add_option("--set", arguments->lab.assignments, "key=value of the scenario, repeatable")
      ->allow_extra_args(false);
  add_laboratory_options(command, arguments->lab);
  add_field_options(command, vo::fields_of(arguments->settings), "Map");
  take_streams(command, {.configurations = {"SCENARIO"}, .others = {"--out", "--cache"}});
  command.callback([arguments] { basin(*arguments); });
}

}  // namespace tools
