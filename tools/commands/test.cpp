#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/exit_code.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/task_share.h"
#include "tools/cli/watched_run.h"
#include "tools/commands/commands.h"
#include "tools/commands/trial_arguments.h"
#include "tools/json/document.h"
#include "tools/laboratory/baseline.h"
#include "tools/laboratory/comparison.h"
#include "tools/laboratory/junit.h"
#include "tools/laboratory/results_json.h"
#include "tools/laboratory/test_report.h"
#include "tools/laboratory/verdict_table.h"
#include "tools/report/html_report.h"
#include "tools/sequence_cache/sequence_cache.h"
#include "tools/trials/test_run.h"
#include "tools/trials/trial_share.h"
#include "tools/trials/trial_words.h"
#include "vo/core/error.h"
#include "vo/files/output.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTestHelp =
    "Says whether a tracker got worse: runs scenarios and checks their bounds (exit code 4 when "
    "one\n"
    "does not hold). Sequences are rendered once and kept in a cache; what this very program has\n"
    "measured before is not measured again, so a run that was killed goes on where it was.\n"
    "PATHS are scenario files, or folders of them without those marked slow.\n\n"
    "With --seeds K every scenario runs with K different random numbers and is judged by its "
    "means.\n"
    "--bounds says what judges: the scenario's own bounds and the baseline if there is one, the\n"
    "baseline alone (what is done when --tracker and --baseline are given), or nothing.\n"
    "Against a baseline a change is an alarm when it is significant (a t-test, an exact one of\n"
    "counts, with Holm's correction over all metrics and scenarios; a single seed has no chance "
    "in\n"
    "it, every difference counts) and larger than the tolerance, to the worse or, unexplained, to\n"
    "the better.";

constexpr const char* kFooter =
    "An outside tracker is a program with its arguments, quoted as for a shell but started "
    "without\n"
    "one, in a folder of its own. {sequence} stands for a folder as `edvo render` makes it, "
    "without\n"
    "truth and, unless the mode is rgbd, without depth; {camera} for its camera.toml; {output} "
    "for\n"
    "the TUM trajectory to write (T_world_camera in any world). They are also in the environment:\n"
    "EDVO_SEQUENCE, EDVO_CAMERA, EDVO_OUTPUT. It exits with 0, or with 5 where frames are missing\n"
    "because it was lost; all that it started ends with it. What is known of edvo alone\n"
    "(keyframes, covariances) is not judged.\n\n"
    "Examples:\n"
    "  edvo test scenarios --junit junit.xml --baseline baseline.json\n"
    "  edvo test scenarios --report report.html\n"
    "  edvo test scenarios --tracker 'my_vo {sequence} {output}' --save-baseline mine.json\n"
    "  edvo test scenarios --tracker 'my_vo {sequence} {output}' --baseline mine.json\n"
    "  edvo test scenarios/room_orbit.toml --seeds 5 --json results.json\n"
    "  edvo test scenarios --tracker 'my_vo --in {sequence} --camera {camera} --out {output}'\n"
    "  edvo test scenarios --tracker 'edvo track {sequence} --preset paper --out {output}'\n"
    "  edvo test scenarios --tracker 'sh -c \"my_vo < $EDVO_SEQUENCE/rgb.txt > $EDVO_OUTPUT\"'\n\n"
    "  sbatch --array=1-40 --wrap 'edvo test scenarios --seeds 20 --shards 40 --trials t'\n"
    "  edvo test scenarios --seeds 20 --shards 40 --collect t --json results.json\n\n"
    "With --trials nothing is judged: each trial is written into the folder, one that is there is "
    "not\n"
    "run again. --collect reads them and does what one process that ran all would have done; "
    "where\n"
    "some are missing it prints the shares to submit again, as `sbatch --array` takes them.\n\n"
    "Exit codes: 0 all hold (with --trials: all have run), 1 edvo crashed in a scenario, 3 a "
    "scenario\n"
    "or scene cannot be used, 4 a bound or the baseline is violated or the outside tracker "
    "failed,\n"
    "5 trials to collect are missing, 6 a trial there was measured with another program, tracker,\n"
    "scenario or scene, 75 a disk was full; the other scenarios still run.";

struct TestArguments {
  std::vector<std::string> paths{"scenarios"};
  LiveArguments live;
  bool slow = false;
  bool quiet = false;
  bool no_sync = false;
  int threads = 0;
  std::string cache;
  std::string tracker;
  TrackerLimits limits;
  std::string junit;
  std::string json;
  std::string report;
  std::string bounds;  ///< a BoundsSource's name; empty = by what is compared
  std::string baseline;
  bool update_baseline = false;
  std::string save_baseline;
  ShareArguments shares;
  RunSettings run;
  ComparisonOptions comparison;
};

/// Checks the options of bounds and baseline, and says which judge where the user did not.
void complete_judges(TestArguments& arguments) {
  if (arguments.update_baseline) {
    if (arguments.baseline.empty() || !arguments.save_baseline.empty()) {
      vo::fail_as(vo::ErrorKind::usage,
                  "--update-baseline: expected --baseline FILE with it, and no --save-baseline");
    }
    arguments.save_baseline = std::exchange(arguments.baseline, "");
  }
  const bool is_compared = !arguments.baseline.empty();
  BoundsSource& bounds = arguments.run.bounds;
  if (arguments.bounds.empty()) {
    bounds = arguments.run.trial.tracker && is_compared ? BoundsSource::baseline
                                                        : BoundsSource::scenario;
    return;
  }
  bounds = vo::parse_enum<BoundsSource>(arguments.bounds);
  if (bounds == BoundsSource::baseline && !is_compared) {
    vo::fail_as(vo::ErrorKind::usage, "--bounds baseline: expected --baseline FILE with it");
  }
  if (bounds == BoundsSource::none && is_compared) {
    vo::fail_as(vo::ErrorKind::usage, "--bounds none: expected no --baseline with it");
  }
}

/// Checks the options of shares, which are not judged before all are collected.
void check_shares(const TestArguments& arguments) {
  arguments.shares.check();
  for (const std::string& judging :
       {arguments.junit, arguments.json, arguments.report, arguments.bounds, arguments.baseline,
        arguments.save_baseline}) {
    if (arguments.shares.runs_share() && !judging.empty()) {
      vo::fail_as(vo::ErrorKind::usage,
                  "--trials: expected no --junit, --json, --report, --bounds or baseline with it; "
                  "--collect takes them");
    }
  }
}

/// Throws where the command line names no tracker, but says that there is one.
void check_tracker_options(const CLI::App& command, TestArguments& arguments) {
  if (!arguments.tracker.empty()) {
    return;
  }
  if (command.count("--tracker") > 0) {
    vo::fail_as(vo::ErrorKind::usage, "--tracker: is empty, expected a command");
  }
  for (const vo::Field& field : vo::fields_of(arguments.limits)) {
    const std::string option = option_name(field.key);
    if (command.count(option) > 0) {
      vo::fail_as(vo::ErrorKind::usage, option, ": expected --tracker CMD with it");
    }
  }
}

void complete(TestArguments& arguments) {
  check_shares(arguments);
  RunSettings& run = arguments.run;
  if (!arguments.tracker.empty()) {
    run.trial.tracker = {.command = arguments.tracker,
                         .limits = arguments.limits,
                         .withheld = fs::absolute(cache_folder(arguments.cache))};
  }
  check_usage([&] {
    run.validate();
    arguments.comparison.validate();
  });
  complete_judges(arguments);
  run.trial.cache = cache_folder(arguments.cache);
  for (const std::string& file :
       {arguments.junit, arguments.json, arguments.report, arguments.save_baseline}) {
    if (!file.empty()) {
      vo::require_writable(file);
    }
  }
}

vo::OutputPolicy policy_of(const TestArguments& arguments) {
  return {vo::ExistingOutput::replace,
          arguments.no_sync ? vo::Durability::unsynced : vo::Durability::synced,
          throw_if_interrupted};
}

/// Writes a file that the user named; nothing if the name is empty.
void write_asked(const std::string& file, const std::string& bytes,
                 const vo::OutputPolicy& policy) {
  if (!file.empty()) {
    vo::write_file(file, bytes, policy);
  }
}

/// Returns the exit code of a trial that was not measured. A crash of edvo's own is its defect, one
/// of an outside tracker is what the test was to find.
int code_of(ProblemKind kind, bool is_outside) {
  switch (kind) {
    case ProblemKind::temporary:
      return exit_code::kTemporary;
    case ProblemKind::unusable:
      return exit_code::kUnusableInput;
    case ProblemKind::crash:
      return is_outside ? exit_code::kBoundViolated : exit_code::kInternalError;
    default:
      return exit_code::kBoundViolated;
  }
}

/// Returns the exit code that a user must know of first.
int worst_code(const TestResults& results, const std::vector<Change>& changes, bool is_outside) {
  const bool is_changed = has_alarm(changes);
  std::set<int> codes;
  for (const ScenarioResult& scenario : results.scenarios) {
    if (is_changed || scenario.verdict() == Verdict::failed) {
      codes.insert(exit_code::kBoundViolated);
    }
    for (const TrialResult& trial : scenario.trials) {
      if (!trial.problem.empty()) {
        codes.insert(code_of(trial.kind, is_outside));
      }
    }
  }
  for (const int code : {exit_code::kTemporary, exit_code::kInternalError,
                         exit_code::kUnusableInput, exit_code::kBoundViolated}) {
    if (codes.contains(code)) {
      return code;
    }
  }
  return exit_code::kOk;
}

/// Reads the results that the user named as the baseline, if any.
std::optional<TestResults> read_baseline(const TestArguments& arguments) {
  if (arguments.baseline.empty()) {
    return {};
  }
  return read_results(arguments.baseline);
}

std::vector<Change> changes_from(const TestResults& baseline, const TestResults& results,
                                 const ComparisonOptions& options, const Session& session) {
  print_notes(baseline_notes(baseline, results), session);
  return compare_results(baseline, results, options);
}

/// Prints the table and writes the files that the user named. Where one of them is stdout,
/// the table is on stderr.
void write_results(const TestArguments& arguments, const TestResults& results,
                   const std::vector<Change>& changes, const Session& session) {
  const auto [out, colours] =
      speech_beside(session, {arguments.junit, arguments.json, arguments.report});
  out << format_verdicts(results, changes, colours);
  write_asked(arguments.json, json_text(results_json(results)), policy_of(arguments));
  write_asked(arguments.junit, format_junit(results, changes), policy_of(arguments));
  if (!arguments.report.empty()) {
    write_asked(arguments.report, html_report(test_reports(results, changes)),
                policy_of(arguments));
  }
  if (!arguments.save_baseline.empty()) {
    print_notes(save_baseline(arguments.save_baseline, results, policy_of(arguments)), session);
  }
}

/// Compares and writes the results of all trials, and returns the exit code.
int judge(const TestArguments& arguments, const TestResults& results,
          const std::optional<TestResults>& baseline, const Session& session) {
  const std::vector<Change> changes =
      baseline ? changes_from(*baseline, results, arguments.comparison, session)
               : std::vector<Change>();
  write_results(arguments, results, changes, session);
  return worst_code(results, changes, arguments.run.trial.tracker.has_value());
}

/// Runs the trials of a share, which are judged when all are collected.
int test_share(const TestArguments& arguments, const std::vector<fs::path>& files, ProgressBar& bar,
               const Session& session) {
  const TaskShare task = chosen_share(arguments.shares.shard, arguments.shares.shards);
  const std::size_t trials = files.size() * static_cast<std::size_t>(arguments.run.seeds);
  WatchedTrials watched(arguments.live, share_name(task), trials / task.tasks + 1);
  const ShareOutcome outcome = run_share(
      load_scenarios(files, BoundsSource::none),
      {{task.task, task.tasks}, {arguments.shares.trials, policy_of(arguments).durability}},
      arguments.run, watched.progress(bar.callback()), throw_if_interrupted,
      [&](const TrialJob& job, const TrialResult& trial) {
        watched.tell(trial_name(job), trial_word(job, trial, arguments.run), trial_figures(trial));
      });
  bar.erase();
  const std::string text = share_text(task, outcome);
  const int code = print_share(text, outcome, session);
  watched.finish(text);
  return code;
}

int collect(const TestArguments& arguments, const std::vector<fs::path>& files,
            const std::optional<TestResults>& baseline, ProgressBar& bar, const Session& session) {
  std::vector<LoadedScenario> scenarios = load_scenarios(files, arguments.run.bounds);
  CollectedTrials collected = collect_trials(scenarios, arguments.shares.collect, arguments.run,
                                             bar.callback("collecting"));
  bar.erase();
  if (!collected.missing.empty()) {
    const std::set<std::string> outputs{arguments.json, arguments.junit, arguments.report};
    return print_missing(arguments.shares, collected,
                         outputs.contains(vo::kStdoutPath) ? MissingShares::with_message
                                                           : MissingShares::also_on_stdout,
                         session);
  }
  return judge(arguments,
               judge_trials(std::move(scenarios), std::move(collected.trials), arguments.run),
               baseline, session);
}

int test(TestArguments& arguments, const Session& session) {
  complete(arguments);
  const auto limit = CommonOptions{.threads = arguments.threads}.limit_threads();
  ProgressBar bar("testing", CommonOptions{.quiet = arguments.quiet}.verbosity());
  bar.announce();
  const std::optional<TestResults> baseline = read_baseline(arguments);
  const std::vector<fs::path> files =
      find_scenarios({arguments.paths.begin(), arguments.paths.end()},
                     arguments.slow ? SlowScenarios::include : SlowScenarios::leave_out);
  const ShareArguments& shares = arguments.shares;
  if (!arguments.report.empty() || shares.runs_share() || shares.collects()) {
    arguments.run.trial.pictures = pictures_of_each(files.size());
  }
  if (shares.runs_share()) {
    return test_share(arguments, files, bar, session);
  }
  if (shares.collects()) {
    return collect(arguments, files, baseline, bar, session);
  }
  WatchedTrials watched(arguments.live, vo::concat(files.size(), " scenarios"),
                        files.size() * static_cast<std::size_t>(arguments.run.seeds));
  const TestResults results = run_tests(
      files, arguments.run, watched.progress(bar.callback()), throw_if_interrupted,
      [&](const TrialJob& job, const TrialResult& trial) {
        watched.tell(trial_name(job), trial_word(job, trial, arguments.run), trial_figures(trial));
      });
  bar.erase();
  const int code = judge(arguments, results, baseline, session);
  watched.finish(passed_scenarios(results));
  return code;
}

void add_run_options(CLI::App& command, TestArguments& arguments) {
  arguments.run.jobs = static_cast<int>(CommonOptions{}.max_threads());
  command.add_option("PATHS", arguments.paths, "scenario files or folders [scenarios]");
  command.add_flag("--slow", arguments.slow, "also those marked slow");
  command.add_option("--jobs,-j", arguments.run.jobs, "scenarios at a time [cores]");
  command.add_option("--seeds", arguments.run.seeds, "with so many random numbers each [1]");
  command.add_flag("--again", arguments.run.trial.measure_again,
                   "measure what this program has measured before");
  command.add_option("--cache", arguments.cache, "folder of the cache [$XDG_CACHE_HOME/edvo]");
  command.add_option("--tracker", arguments.tracker,
                     "test this program: CMD with {sequence} {camera} {output}");
  command.add_option("--threads", arguments.threads, "threads at most; 0 = all cores")
      ->check(CLI::NonNegativeNumber);
  add_live_options(command, arguments.live);
  add_quiet_flag(command, arguments.quiet);
  add_no_sync_flag(command, arguments.no_sync);
}

}  // namespace

void add_test_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("test", kTestHelp);
  const auto arguments = std::make_shared<TestArguments>();
  command.footer(kFooter);
  add_run_options(command, *arguments);
  command.add_option("--junit", arguments->junit, "write JUnit XML; replaces the file");
  command.add_option("--json", arguments->json, "write the results; replaces the file");
  command.add_option("--report", arguments->report,
                     "write an HTML report of all scenarios, tracked for it; replaces the file");
  command.add_option("--bounds", arguments->bounds, "what judges: scenario, baseline or none")
      ->check(is_name_of<BoundsSource>());
  command.add_option("--baseline", arguments->baseline, "results to compare with");
  command.add_option("--save-baseline", arguments->save_baseline,
                     "put the results into this baseline, beside other scenarios' in it");
  command.add_flag("--update-baseline", arguments->update_baseline,
                   "--save-baseline to the file of --baseline, without comparing");
  add_share_options(command, arguments->shares);
  add_field_options(command, vo::fields_of(arguments->comparison), "Baseline");
  add_field_options(command, vo::fields_of(arguments->limits), "Limits of --tracker");
  take_streams(command, {.inputs = {"--baseline"},
                         .configurations = {"PATHS"},
                         .outputs = {"--junit", "--json", "--report"},
                         .written = {"--save-baseline"},
                         .others = {"--cache", "--trials", "--collect"},
                         .defaults = {{"PATHS", "scenarios"}},
                         .in_place = {{"--baseline", "--save-baseline"}}});
  command.callback([arguments, &command, &session] {
    check_tracker_options(command, *arguments);
    session.status = test(*arguments, session);
  });
}

}  // namespace tools
