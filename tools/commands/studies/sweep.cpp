#include "tools/studies/sweep.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tools/cli/exit_code.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/commands/studies/study_commands.h"
#include "tools/commands/trial_arguments.h"
#include "vo/core/error.h"
#include "vo/files/result_files.h"

namespace tools {
namespace {

constexpr const char* kSweepHelp =
    "Measures scenarios with every combination of the values of any of their options. Writes\n"
    "DIR/sweep.csv, .svg (against the values of the first option) and .md. Keys are those of\n"
    "scenario files; commas in brackets belong to a value. More than one trial of a combination:\n"
    "sweep.md also has the medians over all scenarios and seeds. With --trials no table is made: "
    "each\n"
    "trial is written into the folder, one that is there is not run again. --collect makes of "
    "them\n"
    "what one process would have made; without --out it is only printed.";

constexpr const char* kSweepExamples =
    "Examples:\n"
    "  edvo sweep scenarios/room_tour.toml --set odometry.tracker.pyramid.levels=2,3,4 --out "
    "sweep\n"
    "  edvo sweep scenarios/a.toml scenarios/b.toml --set path.rate=10,15,30 \\\n"
    "       --set odometry.preset=paper,default --seeds 3 --out sweep\n"
    "  edvo sweep scenarios/a.toml --set 'sensor.noise.full_well=[6000,6000,6000],[900,900,900]' "
    "--out sweep\n"
    "  edvo sweep scenarios/a.toml --set path.rate=10,15,30 --seeds 20 --shards 12 --trials t\n"
    "  edvo sweep scenarios/a.toml --set path.rate=10,15,30 --seeds 20 --shards 12 --collect t "
    "--out "
    "sweep\n\n"
    "Exit codes: 3 a scenario or scene cannot be used, 5 trials to collect are missing (the shares "
    "to\n"
    "submit again are printed), 6 a trial there was measured with other values, 75 a disk was "
    "full.";

struct SweepArguments {
  LaboratoryArguments lab;
  std::vector<std::string> scenarios;
  ShareArguments shares;
};

std::string command_line(const SweepArguments& arguments) {
  std::string text = "edvo sweep";
  for (const std::string& scenario : arguments.scenarios) {
    text += " " + scenario;
  }
  text += format_assignments(arguments.lab.assignments);
  return text + vo::concat(" --seeds ", arguments.lab.run.seeds, " --out DIR");
}

void complete(SweepArguments& arguments) {
  arguments.shares.check();
  const bool has_out = !arguments.lab.out.empty();
  if (arguments.shares.runs_share() && has_out) {
    vo::fail_as(vo::ErrorKind::usage, "--trials: expected no --out with it; --collect takes it");
  }
  if (!arguments.shares.runs_share() && !arguments.shares.collects() && !has_out) {
    vo::fail_as(vo::ErrorKind::usage, "--out is required");
  }
  arguments.lab.complete();
}

/// Runs the trials of a share, of which a table is made when all are collected.
int sweep_share(const SweepArguments& arguments, const std::vector<LoadedScenario>& scenarios,
                const SweepSettings& settings, const Session& session) {
  const TaskShare task = chosen_share(arguments.shares.shard, arguments.shares.shards);
  ProgressBar bar("measuring", arguments.lab.common.verbosity());
  bar.announce();
  const vo::Durability durability = arguments.lab.common.output_policy().durability;
  const ShareOutcome outcome =
      run_share(scenarios, {{task.task, task.tasks}, {arguments.shares.trials, durability}},
                settings.run, bar.callback(), throw_if_interrupted, {});
  bar.erase();
  return print_share(share_text(task, outcome), outcome, session);
}

/// Writes the table and prints it; without a folder it is only printed.
void deliver_sweep(const SweepArguments& arguments, const StudyReport& report) {
  if (arguments.lab.out.empty()) {
    print_study(report, arguments.lab.common);
    return;
  }
  deliver_study(report, command_line(arguments), arguments.lab.out, arguments.lab.common);
}

int collect_sweep(const SweepArguments& arguments, const std::vector<LoadedScenario>& scenarios,
                  const SweepSettings& settings, const Session& session) {
  ProgressBar bar("collecting", arguments.lab.common.verbosity());
  const CollectedTrials collected =
      collect_trials(scenarios, arguments.shares.collect, settings.run, bar.callback());
  bar.erase();
  if (!collected.missing.empty()) {
    return print_missing(
        arguments.shares, collected,
        arguments.lab.common.json ? MissingShares::with_message : MissingShares::also_on_stdout,
        session);
  }
  deliver_sweep(arguments, sweep_report(scenarios, collected.trials, settings));
  return exit_code::kOk;
}

int sweep_all(const SweepArguments& arguments, const std::vector<LoadedScenario>& scenarios,
              const SweepSettings& settings) {
  const vo::FolderForResults folder(arguments.lab.out);
  ProgressBar bar("measuring", arguments.lab.common.verbosity());
  bar.announce();
  const std::vector<TrialResult> trials =
      run_trials(trial_jobs(scenarios, settings.run.seeds), settings.run, bar.callback(),
                 throw_if_interrupted);
  bar.erase();
  deliver_sweep(arguments, sweep_report(scenarios, trials, settings));
  return exit_code::kOk;
}

int run(SweepArguments& arguments, const Session& session) {
  const auto limit = arguments.lab.common.limit_threads();
  complete(arguments);
  const SweepSettings settings{arguments.lab.run, swept_options(arguments.lab.assignments)};
  const std::vector<std::filesystem::path> files = find_scenarios(
      {arguments.scenarios.begin(), arguments.scenarios.end()}, SlowScenarios::leave_out);
  const std::vector<LoadedScenario> scenarios = swept_scenarios(files, settings.options);
  if (arguments.shares.runs_share()) {
    return sweep_share(arguments, scenarios, settings, session);
  }
  return arguments.shares.collects() ? collect_sweep(arguments, scenarios, settings, session)
                                     : sweep_all(arguments, scenarios, settings);
}

}  // namespace

void add_sweep_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("sweep", kSweepHelp);
  const auto arguments = std::make_shared<SweepArguments>();
  command.footer(kSweepExamples);
  command.add_option("SCENARIOS", arguments->scenarios, "scenario files or folders")->required();
  command.add_option("--set", arguments->lab.assignments, "key=a,b,c of the scenario, repeatable")
      ->allow_extra_args(false)
      ->required();
  command.add_option("--seeds", arguments->lab.run.seeds, "with so many random numbers each [1]");
  add_laboratory_options(command, arguments->lab);
  command.get_option("--out")->required(false);
  command.add_flag("--again", arguments->lab.run.trial.measure_again,
                   "measure what this program has measured before");
  add_share_options(command, arguments->shares);
  take_streams(command, {.configurations = {"SCENARIOS"},
                         .others = {"--out", "--cache", "--trials", "--collect"}});
  command.callback([arguments, &session] { session.status = run(*arguments, session); });
}

}  // namespace tools
