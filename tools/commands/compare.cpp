#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/exit_code.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "tools/laboratory/build_test.h"
#include "tools/laboratory/comparison.h"
#include "tools/laboratory/comparison_json.h"
#include "tools/laboratory/comparison_quality.h"
#include "tools/laboratory/results_json.h"
#include "tools/laboratory/verdict_table.h"
#include "tools/plot/table.h"
#include "vo/core/error.h"
#include "vo/files/input.h"

namespace tools {
namespace {

constexpr const char* kCompareHelp =
    "Two results of `edvo test --json`, or two builds of edvo, side by side: every metric of "
    "every\n"
    "scenario with the probability that its change is chance. Exit code 4 when a change is\n"
    "significant over all of them and larger than the tolerance.\n"
    "With --halves N a single result is compared with itself, N times one random half of its "
    "seeds\n"
    "with the other: how often that is an alarm is the rate of false alarms.\n"
    "With --power it tells what growth of a metric is an alarm in nine of ten comparisons: of one\n"
    "result, compared with other seeds; of two, with the same seeds and changes that spread as\n"
    "those between them.";

constexpr const char* kCompareExamples =
    "Examples:\n"
    "  edvo compare before.json after.json\n"
    "  edvo compare before.json after.json --json > changes.json\n"
    "  edvo compare --build-a old/edvo --build-b build/release/edvo --seeds 5 scenarios\n"
    "  edvo compare results.json --halves 200 --worse-percent 0 --better-percent 0\n"
    "  edvo compare before.json after.json --power --metric rpe_translation_rmse_m";

constexpr int kMostHalves = 1'000'000;

struct CompareArguments {
  bool json = false;
  bool quiet = false;
  std::vector<std::string> inputs;
  std::string build_a;
  std::string build_b;
  int seeds = 1;
  int halves = 0;
  bool power = false;
  std::string metric = "ate_rmse_m";
  ComparisonOptions options;
};

/// Returns the results of another build's own `edvo test`.
TestResults run_build(const CompareArguments& arguments, const std::string& build,
                      ProgressBar& bar) {
  vo::require(std::filesystem::exists(build), build, ": there is no such program");
  bar.erase();
  if (!arguments.quiet) {
    std::cerr << build << " test --seeds " << arguments.seeds << "\n";
  }
  return test_build(build, arguments.inputs, arguments.seeds, throw_if_interrupted);
}

void print_missing(const TestResults& a, const TestResults& b) {
  for (const std::string& name : missing_scenarios(a, b)) {
    std::cout << name << ": only in the first\n";
  }
  for (const std::string& name : missing_scenarios(b, a)) {
    std::cout << name << ": only in the second\n";
  }
}

int compare_halves(const CompareArguments& arguments, ProgressBar& bar) {
  if (arguments.inputs.size() != 1) {
    vo::fail_as(vo::ErrorKind::usage, "compare: expected one result with --halves");
  }
  const TestResults results = read_results(arguments.inputs[0]);
  const int alarms =
      count_false_alarms(results, arguments.halves, arguments.options, bar.callback());
  bar.erase();
  if (arguments.json) {
    std::cout << json_text(self_comparison_json(alarms, arguments.halves, arguments.options));
    return exit_code::kOk;
  }
  std::cout << alarms << " of " << arguments.halves << " comparisons with itself raise an alarm, "
            << arguments.options.level * arguments.halves << " are expected at most\n";
  return exit_code::kOk;
}

std::string growth_text(double percent) {
  return std::isfinite(percent) ? "+" + format_decimals(percent, 0) + " %" : "> x100";
}

int tell_power(const CompareArguments& arguments, ProgressBar& bar) {
  const std::size_t count = arguments.inputs.size();
  if (count != 1 && count != 2) {
    vo::fail_as(vo::ErrorKind::usage, "compare: expected one or two results with --power");
  }
  const TestResults a = read_results(arguments.inputs[0]);
  const TestResults b = read_results(arguments.inputs[count - 1]);
  const Seeds seeds = count == 1 ? Seeds::other : Seeds::same;
  Table table{.columns = {{"scenario"}, {count == 1 ? "seeds_differ_%" : "changes_differ_%"}}};
  for (const int number : kPowerSeeds) {
    table.columns.push_back({vo::concat(number, "_seeds")});
  }
  for (const DetectableChange& change :
       detectable_changes(a, b, arguments.metric, seeds, arguments.options)) {
    std::vector<TableCell> row{change.scenario, format_decimals(100 * change.deviation, 1)};
    for (const double percent : change.percent) {
      row.emplace_back(growth_text(percent));
    }
    table.add_row(std::move(row));
  }
  bar.erase();
  std::cout << "growth of " << arguments.metric << " that is an alarm in 90 % of comparisons\n"
            << as_text(table);
  return exit_code::kOk;
}

int compare(const CompareArguments& arguments, const Session& session) {
  ProgressBar bar("comparing", CommonOptions{.quiet = arguments.quiet}.verbosity());
  check_usage([&] { arguments.options.validate(); });
  bar.announce();
  if (arguments.power) {
    return tell_power(arguments, bar);
  }
  if (arguments.halves > 0) {
    return compare_halves(arguments, bar);
  }
  const bool has_builds = !arguments.build_a.empty() && !arguments.build_b.empty();
  if (!has_builds && arguments.inputs.size() != 2) {
    vo::fail_as(vo::ErrorKind::usage,
                "compare: expected two results, or --build-a, --build-b and scenarios");
  }
  if (has_builds && std::find(arguments.inputs.begin(), arguments.inputs.end(), vo::kStdinPath) !=
                        arguments.inputs.end()) {
    vo::fail_as(vo::ErrorKind::usage,
                "RESULTS: - cannot be read by both builds, expected scenarios");
  }
  const TestResults a =
      has_builds ? run_build(arguments, arguments.build_a, bar) : read_results(arguments.inputs[0]);
  const TestResults b =
      has_builds ? run_build(arguments, arguments.build_b, bar) : read_results(arguments.inputs[1]);
  const std::vector<Change> changes = compare_results(a, b, arguments.options);
  bar.erase();
  vo::require(!changes.empty(), "the two results have no scenario in common");
  if (arguments.json) {
    std::cout << json_text(comparison_json(a, b, changes, arguments.options));
  } else {
    std::cout << format_changes(changes, session.out);
    print_missing(a, b);
  }
  return has_alarm(changes) ? exit_code::kBoundViolated : exit_code::kOk;
}

}  // namespace

void add_compare_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("compare", kCompareHelp);
  const auto arguments = std::make_shared<CompareArguments>();
  command.footer(kCompareExamples);
  command.add_option("RESULTS", arguments->inputs,
                     "two results, or with builds: scenarios, folders");
  command.add_option("--build-a", arguments->build_a, "an edvo program");
  command.add_option("--build-b", arguments->build_b, "another");
  command.add_option("--seeds", arguments->seeds, "of the builds [1]")->check(at_least_one());
  command.add_option("--halves", arguments->halves, "compare one result with itself so often")
      ->check(from_one_to(kMostHalves));
  add_json_flag(command, arguments->json);
  add_quiet_flag(command, arguments->quiet);
  command.add_flag("--power", arguments->power, "tell what growth of a metric is found");
  command.add_option("--metric", arguments->metric, "of --power [ate_rmse_m]");
  add_field_options(command, vo::fields_of(arguments->options), "Alarms");
  take_streams(command, {.inputs = {"RESULTS"}, .read = {"--build-a", "--build-b"}});
  command.callback([arguments, &session] { session.status = compare(*arguments, session); });
}

}  // namespace tools
