#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include "tools/cli/exit_code.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/commands/commands.h"
#include "tools/depth/depth_output.h"
#include "tools/depth/depth_pictures.h"
#include "tools/pictures/frame_gallery.h"
#include "tools/pictures/panel_writer.h"
#include "tools/plot/trajectory_svg.h"
#include "tools/report/html_report.h"
#include "tools/report/report.h"
#include "tools/report/scenario_report.h"
#include "tools/scenario/mono_scenario.h"
#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "vo/core/error.h"
#include "vo/dataset/trajectory_file.h"
#include "vo/files/output.h"
#include "vo/files/result_files.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRunHelp =
    "Runs a scenario: renders its sequence, tracks it, evaluates it against the exact truth and\n"
    "checks its bounds (exit code 4 when one is violated). DIR then holds\n"
    "  report.html              for a browser: trajectory in its scene, errors over time, "
    "pictures\n"
    "  report.md, report.json   metrics, bounds, verdict, every option\n"
    "  trajectory.svg           truth and estimate, coloured by error, and the error over time\n"
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
  std::string scenario;
  std::string out;
  int debug_images = 30;
  bool report_times = false;
};

/// Returns the HTML report of the run.
std::string browser_report(const RunArguments& arguments, const Scenario& scenario,
                           const Outcome& outcome, const FrameGallery& gallery) {
  ScenarioReport report = scenario_report(scenario, outcome);
  report.gallery = gallery;
  if (arguments.report_times) {
    report.times = outcome.tracking.times;
  }
  return html_report({report});
}

/// Returns the files that a run writes beside sequence/, panels/ and report.html.
std::vector<vo::NamedBytes> result_files(const Scenario& scenario, const Outcome& outcome) {
  const vo::Trajectory& estimate = outcome.tracking.trajectory;
  std::vector<vo::NamedBytes> files = {
      {"trajectory.txt", vo::format_trajectory(estimate)},
      {"frames.csv", vo::format_frame_log(outcome.tracking.frames)},
      {"report.json", report_json(scenario, outcome).dump(2) + "\n"},
      {"report.md", report_markdown(scenario, outcome)}};
  if (!estimate.empty()) {
    files.push_back({"trajectory.svg", draw_trajectory(outcome.truth, estimate)});
  }
  return files;
}

/// Returns whether a folder has no visible files; a killed run leaves hidden ones.
bool is_visibly_empty(const fs::path& folder) {
  return std::all_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [](const fs::directory_entry& entry) {
                       return entry.path().filename().string().starts_with('.');
                     });
}

/// Throws vo::Error if the folder holds files but no sequence of edvo's.
void require_own_folder(const fs::path& folder) {
  if (!fs::exists(folder)) {
    return;
  }
  vo::require(fs::is_directory(folder), folder.string(),
              ": is a file, expected a folder for the results");
  vo::require(fs::exists(folder / "sequence" / "sequence.toml") || is_visibly_empty(folder),
              folder.string(),
              ": holds other files than edvo's, expected a folder for the results");
}

void print(const RunArguments& arguments, const Scenario& scenario, const Outcome& outcome) {
  if (arguments.common.json) {
    nlohmann::ordered_json report = report_json(scenario, outcome);
    report["ms_per_frame"] = time_json(vo::summarize(outcome.tracking.times));
    report["out"] = arguments.out;
    std::cout << report.dump(2) << "\n";
    return;
  }
  const char* folder = scenario.odometry.mode == OdometryMode::rgbd ? "/panels/" : "/maps/";
  std::cout << report_table(scenario, outcome) << "report    " << arguments.out << "/report.html, "
            << arguments.out << "/report.md\n"
            << "pictures  "
            << (outcome.tracking.trajectory.empty() ? "" : arguments.out + "/trajectory.svg, ")
            << (arguments.debug_images > 0 ? arguments.out + folder : "") << "\n";
}

/// Returns an observer that calls both observers in turn; an empty one is skipped.
vo::FrameObserver in_turn(const vo::FrameObserver& first, const vo::FrameObserver& second) {
  return [first, second](const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                         const vo::Tracker& tracker, const vo::TrackingResult& result) {
    for (const vo::FrameObserver& observe : {first, second}) {
      if (observe) {
        observe(frame, pyramid, tracker, result);
      }
    }
  };
}

/// Pictures drawn while a scenario runs: panels/ in mode rgbd, maps/ in modes mono and mapping, and
/// the gallery of the HTML report.
class RunPictures {
 public:
  RunPictures(const RunArguments& arguments, const Scenario& scenario) {
    const fs::path folder = arguments.out;
    const vo::ExistingOutput existing = arguments.common.existing();
    if (scenario.odometry.mode == OdometryMode::rgbd) {
      panels_.emplace(folder / "panels", arguments.debug_images, existing);
    } else {
      maps_.emplace(folder / "maps", arguments.debug_images, existing);
      scale_ = map_scale(scenario.odometry);
    }
  }

  ScenarioObservers observers() {
    const vo::FrameObserver remember = [this](const vo::RgbdFrame& frame, const vo::FramePyramid&,
                                              const vo::Tracker&, const vo::TrackingResult&) {
      time_ = frame.timestamp;
    };
    return {.frame = in_turn(panels_ ? panels_->observer() : remember, gallery_.observer()),
            .map = maps_ ? map_observer() : MapObserver()};
  }

  void commit(const Outcome& outcome) {
    if (panels_) {
      panels_->commit();
    }
    if (maps_) {
      maps_->commit(outcome.maps);
    }
  }

  const FrameGallery& gallery() const { return gallery_; }

 private:
  MapObserver map_observer() {
    return [this, draw = maps_->observer(scale_)](std::size_t frame, const vo::DepthMap& map,
                                                  const vo::DepthImage& truth,
                                                  const vo::SE3& T_world_host) {
      draw(frame, map, truth, T_world_host);
      const SparseDepths depths = sparse_depths(map, truth, divisor(map, truth, scale_));
      gallery_.add_inverse_depth(time_, depths.estimate, depths.truth);
    };
  }

  std::optional<PanelWriter> panels_;
  std::optional<DepthOutput> maps_;
  MapScale scale_ = MapScale::metric;
  double time_ = 0;  ///< s, time of the current frame
  FrameGallery gallery_;
};

int run(const RunArguments& arguments) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  arguments.common.max_threads());
  const Scenario scenario = load_scenario(arguments.scenario);
  const fs::path folder = arguments.out;
  const vo::ExistingOutput existing = arguments.common.existing();
  require_own_folder(folder);
  vo::require(fs::exists(scenario.scene_file()), scenario.file.string(),
              ": scene.gltf: ", scenario.scene_file().string(), ": there is no such file");
  vo::make_folder(folder);
  RunPictures pictures(arguments, scenario);
  ProgressBar render_bar("rendering", arguments.common.verbosity());
  ProgressBar track_bar("tracking", arguments.common.verbosity());
  const Outcome outcome = run_scenario(scenario, folder, existing, pictures.observers(),
                                       {render_bar.callback(), track_bar.callback()});
  std::vector<vo::NamedBytes> files = result_files(scenario, outcome);
  files.push_back(
      {"report.html", browser_report(arguments, scenario, outcome, pictures.gallery())});
  vo::write_results(folder, files, existing);
  pictures.commit(outcome);
  print(arguments, scenario, outcome);
  return outcome.passed() ? exit_code::kOk : exit_code::kBoundViolated;
}

}  // namespace

void add_run_command(CLI::App& program, int& exit_code) {
  CLI::App& command = *program.add_subcommand("run", kRunHelp);
  const auto arguments = std::make_shared<RunArguments>();
  command.footer(kRunExamples);
  command.add_option("SCENARIO", arguments->scenario, "scenario file, .toml")->required();
  command.add_option("--out", arguments->out, "folder for all results")->required();
  command
      .add_option("--debug-images", arguments->debug_images,
                  "a picture of every N-th frame; 0 = none [30]")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--report-times", arguments->report_times,
                   "times of each stage in report.html, which then differs from run to run");
  add_common_options(command, arguments->common);
  command.callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace tools
