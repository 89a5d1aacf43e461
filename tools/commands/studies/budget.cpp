#include "tools/studies/budget.h"

#include <memory>
#include <string>

#include "tools/cli/interrupt.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/commands/studies/study_commands.h"
#include "vo/files/result_files.h"

namespace tools {
namespace {

constexpr const char* kBudgetHelp =
    "Says what share of a scenario's errors each imperfection of its camera causes: the options "
    "of\n"
    "`sensor` and `camera.distortion` that are not at their defaults, one table of options at a\n"
    "time, are switched on one by one and off one by one, and the Shapley values of the strongest\n"
    "are taken from all their combinations. Writes DIR/budget.csv, .svg and .md.";

constexpr const char* kBudgetExamples =
    "Example:\n"
    "  edvo budget scenarios/kinect_orbit.toml --seeds 5 --out budget";

struct BudgetArguments {
  LaboratoryArguments lab;
  std::string scenario;
  BudgetSettings settings;
};

std::string command_line(const BudgetArguments& arguments) {
  std::string text = "edvo budget " + arguments.scenario;
  text += format_assignments(arguments.lab.assignments);
  return text + vo::concat(" --seeds ", arguments.settings.run.seeds, " --top ",
                           arguments.settings.top, " --out DIR");
}

void budget(BudgetArguments& arguments) {
  const auto limit = arguments.lab.common.limit_threads();
  arguments.lab.complete();
  arguments.settings.run = arguments.lab.run;
  check_usage([&] { arguments.settings.validate(); });
  const Scenario scenario =
      load_scenario(arguments.scenario, split_assignments(arguments.lab.assignments));
  const vo::FolderForResults folder(arguments.lab.out);
  ProgressBar bar("measuring", arguments.lab.common.verbosity());
  bar.announce();
  const StudyReport report =
      error_budget(scenario, arguments.settings, bar.callback(), throw_if_interrupted);
  bar.erase();
  deliver_study(report, command_line(arguments), arguments.lab.out, arguments.lab.common);
}

}  // namespace

void add_budget_command(CLI::App& program, Session& /*session*/) {
  CLI::App& command = *program.add_subcommand("budget", kBudgetHelp);
  const auto arguments = std::make_shared<BudgetArguments>();
  arguments->lab.run.seeds = 3;
  command.footer(kBudgetExamples);
  command.add_option("SCENARIO", arguments->scenario, "scenario file, .toml")->required();
  command.add_option("--seeds", arguments->lab.run.seeds, "with so many random numbers each [3]");
  command.add_option("--top", arguments->settings.top,
                     "imperfections told apart in all combinations; the others are one [3]");
  command.add_option("--set", arguments->lab.assignments, "key=value of the scenario, repeatable")
      ->allow_extra_args(false);
  add_laboratory_options(command, arguments->lab);
  take_streams(command, {.configurations = {"SCENARIO"}, .others = {"--out", "--cache"}});
  command.callback([arguments] { budget(*arguments); });
}

}  // namespace tools
