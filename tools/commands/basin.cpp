#include "tools/studies/basin.h"

#include <memory>
#include <string>

#include <tbb/global_control.h>

#include "tools/cli/interrupt.h"
#include "tools/cli/progress_bar.h"
#include "tools/commands/commands.h"
#include "tools/commands/laboratory.h"
#include "tools/commands/study_output.h"
#include "tools/scenario/run_scenario.h"
#include "tools/sequence_cache/sequence_cache.h"
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

Clip load(const BasinArguments& arguments, const Scenario& scenario) {
  ProgressBar bar("rendering", arguments.lab.common.verbosity());
  const vo::Progress progress = bar.callback();
  const CachedSequence cached = cached_sequence(arguments.lab.run.trial.cache, render_job(scenario),
                                                [&](std::size_t done, std::size_t total) {
                                                  throw_if_interrupted();
                                                  progress(done, total);
                                                });
  const vo::SequenceReader sequence(cached.folder);
  return load_clip(sequence, scenario.name, 0,
                   [](std::size_t, std::size_t) { throw_if_interrupted(); });
}

std::string command_line(const BasinArguments& arguments) {
  std::string text = "edvo basin " + arguments.scenario;
  for (const std::string& assignment : arguments.lab.assignments) {
    text += " --set " + assignment;
  }
  const BasinSettings& settings = arguments.settings;
  return text + vo::concat(" --pairs ", settings.pairs, " --apart ", settings.apart, " --steps ",
                           settings.steps, " --max-translation ", settings.max_translation,
                           " --max-rotation-deg ", settings.max_rotation_deg, " --max-error ",
                           settings.max_error, " --max-error-deg ", settings.max_error_deg,
                           " --out DIR");
}

void basin(BasinArguments& arguments) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  arguments.lab.common.max_threads());
  arguments.lab.complete();
  const Scenario scenario = load_scenario(arguments.scenario, arguments.lab.changes());
  vo::require(scenario.odometry.mode == OdometryMode::rgbd, arguments.scenario,
              ": odometry.mode is \"", vo::to_string(scenario.odometry.mode),
              "\", expected \"rgbd\": `edvo basin` aligns points of depth images");
  arguments.settings.tracker = scenario.odometry.tracker;
  arguments.settings.jobs = arguments.lab.run.jobs;
  check_usage([&] { arguments.settings.validate(); });
  vo::make_folder(arguments.lab.out);
  const Clip clip = load(arguments, scenario);
  ProgressBar bar("aligning", arguments.lab.common.verbosity());
  deliver_study(study_basin(clip, arguments.settings, bar.callback()), command_line(arguments),
                arguments.lab.out, arguments.lab.common);
}

}  // namespace

void add_basin_command(CLI::App& program, int& /*exit_code*/) {
  CLI::App& command = *program.add_subcommand("basin", kBasinHelp);
  const auto arguments = std::make_shared<BasinArguments>();
  command.footer(kBasinExamples);
  command.add_option("SCENARIO", arguments->scenario, "scenario file, .toml")->required();
  command.add_option("--set", arguments->lab.assignments, "key=value of the scenario, repeatable")
      ->allow_extra_args(false);
  add_laboratory_options(command, arguments->lab);
  add_field_options(command, vo::fields_of(arguments->settings), "Map");
  command.callback([arguments] { basin(*arguments); });
}

}  // namespace tools
