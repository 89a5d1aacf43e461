#include "tools/studies/sweep.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tools/cli/interrupt.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/commands/studies/study_commands.h"
#include "vo/core/error.h"
#include "vo/files/result_files.h"

namespace tools {
namespace {

constexpr const char* kSweepHelp =
    "Measures scenarios with every combination of the values of any of their options. Writes\n"
    "DIR/sweep.csv, .svg (against the values of the first option) and .md. Keys are those of\n"
    "scenario files; commas in brackets belong to a value. More than one trial of a combination:\n"
    "sweep.md also has the medians over all scenarios and seeds.";

constexpr const char* kSweepExamples =
    "Examples:\n"
    "  edvo sweep scenarios/room_tour.toml --set odometry.tracker.pyramid.levels=2,3,4 --out "
    "sweep\n"
    "  edvo sweep scenarios/a.toml scenarios/b.toml --set path.rate=10,15,30 \\\n"
    "       --set odometry.preset=paper,default --seeds 3 --out sweep\n"
    "  edvo sweep scenarios/a.toml --set 'sensor.noise.full_well=[6000,6000,6000],[900,900,900]' "
    "--out sweep";

struct SweepArguments {
  LaboratoryArguments lab;
  std::vector<std::string> scenarios;
};

/// Splits a list at commas outside of brackets; the brackets are removed from the values.
std::vector<std::string> split_values(const std::string& list) {
  std::vector<std::string> values(list.empty() ? 0 : 1);
  bool is_within = false;
  for (const char c : list) {
    if (c == '[' || c == ']') {
      is_within = c == '[';
    } else if (c == ',' && !is_within) {
      values.emplace_back();
    } else {
      values.back() += c;
    }
  }
  return values;
}

std::vector<SweptOption> swept_options(const std::vector<std::string>& assignments) {
  std::vector<SweptOption> options;
  for (const std::string& assignment : assignments) {
    const auto [key, list] = split_assignment(assignment);
    options.emplace_back(key, split_values(list));
    if (options.back().second.empty()) {
      vo::fail_as(vo::ErrorKind::usage, "--set ", assignment, ": expected key=value,value,...");
    }
  }
  return options;
}

std::string command_line(const SweepArguments& arguments) {
  std::string text = "edvo sweep";
  for (const std::string& scenario : arguments.scenarios) {
    text += " " + scenario;
  }
  text += format_assignments(arguments.lab.assignments);
  return text + vo::concat(" --seeds ", arguments.lab.run.seeds, " --out DIR");
}

void run(SweepArguments& arguments) {
  const auto limit = arguments.lab.common.limit_threads();
  arguments.lab.complete();
  const SweepSettings settings{arguments.lab.run, swept_options(arguments.lab.assignments)};
  const std::vector<std::filesystem::path> files = find_scenarios(
      {arguments.scenarios.begin(), arguments.scenarios.end()}, SlowScenarios::leave_out);
  vo::make_folder(arguments.lab.out);
  ProgressBar bar("measuring", arguments.lab.common.verbosity());
  bar.announce();
  const StudyReport report = sweep(files, settings, bar.callback(), throw_if_interrupted);
  bar.erase();
  deliver_study(report, command_line(arguments), arguments.lab.out, arguments.lab.common);
}

}  // namespace

void add_sweep_command(CLI::App& program, Session& /*session*/) {
  CLI::App& command = *program.add_subcommand("sweep", kSweepHelp);
  const auto arguments = std::make_shared<SweepArguments>();
  command.footer(kSweepExamples);
  command.add_option("SCENARIOS", arguments->scenarios, "scenario files or folders")->required();
  command.add_option("--set", arguments->lab.assignments, "key=a,b,c of the scenario, repeatable")
      ->allow_extra_args(false)
      ->required();
  command.add_option("--seeds", arguments->lab.run.seeds, "with so many random numbers each [1]");
  add_laboratory_options(command, arguments->lab);
  take_streams(command, {.inputs = {"SCENARIOS"}, .others = {"--out", "--cache"}});
  command.callback([arguments] { run(*arguments); });
}

}  // namespace tools
