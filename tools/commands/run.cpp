#include <iostream>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "tools/cli/exit_code.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/watched_run.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "tools/report/report.h"
#include "tools/report/run_report.h"
#include "tools/scenario/mono_scenario.h"

namespace tools {
namespace {

constexpr const char* kRunHelp =
    "Runs a scenario: renders its sequence, tracks it, evaluates it against the exact truth and\n"
    "checks its bounds (exit code 4 when one is violated). DIR then holds\n"
    "  report.html              for a browser: trajectory in its scene, errors over time, "
    "pictures\n"
    "  report.md, report.json   metrics, bounds, verdict, every option\n"
    "  trajectory.svg           truth and estimate, aligned as for the ATE, and the error over "
    "time\n"
    "  panels/                  image | edges | depth | residual before and after, every N-th "
    "frame\n"
    "  maps/                    of a monocular scenario instead: depth.csv, true | estimated depth "
    "| "
    "error\n"
    "  trajectory.txt           the estimate; frames.csv: status and covariance of every frame\n"
    "  sequence/                the rendered sequence, used again when its inputs are the same";

constexpr const char* kRunExamples =
    "Example:\n"
    "  edvo run scenarios/room_tour.toml --out build/room_tour";

struct RunArguments {
  CommonOptions common;
  LiveArguments live;
  std::string scenario;
  std::string out;
  RunReportOptions report;
};

void print(const RunArguments& arguments, const Scenario& scenario, const Outcome& outcome,
           const Colours& colours) {
  if (arguments.common.json) {
    nlohmann::ordered_json report = report_json(scenario, outcome);
    report["ms_per_frame"] = time_json(vo::summarize(outcome.tracking.times));
    report["out"] = arguments.out;
    std::cout << json_text(report);
    return;
  }
  const char* folder = scenario.odometry.mode == OdometryMode::rgbd ? "/panels/" : "/maps/";
  std::cout << report_table(scenario, outcome, colours) << "report    " << arguments.out
            << "/report.html, " << arguments.out << "/report.md\n"
            << "pictures  "
            << (outcome.tracking.trajectory.empty() ? "" : arguments.out + "/trajectory.svg, ")
            << (arguments.report.debug_images > 0 ? arguments.out + folder : "") << "\n";
}

/// Returns whether a scenario's estimate is in the world, and of the scale, of the truth.
bool is_comparable(const Scenario& scenario) {
  return map_scale(scenario.odometry) == MapScale::metric;
}

/// Returns what is told of a scenario's stages: the bar, and the page if there is one. It refers to
/// all of them.
RunProgress progress_on(WatchedRun& watched, const Scenario& scenario, ProgressBar& bar) {
  RunProgress progress{watched.progress(bar.callback()), bar.callback("tracking"), {}, {}, {}};
  if (scenario.odometry.mode == OdometryMode::mapping) {
    progress.track = watched.progress(progress.track);
  }
  if (watched.page() != nullptr) {
    progress.before_rendering = [&](const synth::SequenceRecipe& recipe) {
      watched.begin(rendering_stage(recipe, scenario.name));
    };
    progress.rendered = rendered_frames_on(watched, scenario.camera.camera().depth_units_per_m);
    progress.before_tracking = [&](const vo::SequenceReader& sequence) {
      watched.begin(
          tracking_stage(sequence, scenario.name,
                         is_comparable(scenario) ? sequence.ground_truth() : vo::Trajectory()));
    };
  }
  return progress;
}

ScenarioObservers observers_on(WatchedRun& watched) {
  if (watched.page() == nullptr) {
    return {};
  }
  return {
      .frame = watched.observer({}),
      .map = [&page = *watched.page()](std::size_t, const vo::DepthMap& map, const vo::DepthImage&,
                                       const vo::SE3&) { page.show(map); }};
}

int run(const RunArguments& arguments, const Session& session) {
  const auto limit = arguments.common.limit_threads();
  const Scenario scenario = load_scenario(arguments.scenario);
  ProgressBar bar("rendering", arguments.common.verbosity());
  bar.announce("reading the scene of " + arguments.scenario);
  WatchedRun watched(arguments.live);
  const RunProgress progress = progress_on(watched, scenario, bar);
  const Outcome outcome = run_and_report(scenario, arguments.out, arguments.common.output_policy(),
                                         arguments.report, progress, observers_on(watched));
  bar.erase();
  print(arguments, scenario, outcome, session.out);
  watched.finish(outcome.passed() ? "all bounds hold" : "a bound is violated");
  return outcome.passed() ? exit_code::kOk : exit_code::kBoundViolated;
}

}  // namespace

void add_run_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("run", kRunHelp);
  const auto arguments = std::make_shared<RunArguments>();
  command.footer(kRunExamples);
  command.add_option("SCENARIO", arguments->scenario, "scenario file, .toml")->required();
  command.add_option("--out", arguments->out, "folder for all results")->required();
  command
      .add_option("--debug-images", arguments->report.debug_images,
                  "a picture of every N-th frame; 0 = none [30]")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--report-times", arguments->report.times,
                   "times of each stage in report.html, which then differs from run to run");
  add_live_options(command, arguments->live);
  add_common_options(command, arguments->common);
  take_streams(command, {.configurations = {"SCENARIO"}, .written = {"--out"}});
  command.callback([arguments, &session] { session.status = run(*arguments, session); });
}

}  // namespace tools
