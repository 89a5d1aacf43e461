#include "tools/report/run_report.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/depth/depth_output.h"
#include "tools/depth/depth_pictures.h"
#include "tools/json/document.h"
#include "tools/pictures/frame_gallery.h"
#include "tools/pictures/panel_writer.h"
#include "tools/report/html_report.h"
#include "tools/report/report.h"
#include "tools/report/scenario_report.h"
#include "tools/report/trajectory_plot.h"
#include "tools/scenario/mono_scenario.h"
#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/files/partial_file.h"
#include "vo/files/result_files.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/output_folders/file_records.h"
#include "vo/output_folders/staged_folder.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTrajectoryPlot = "trajectory.svg";

/// Returns the HTML report of the run.
std::string browser_report(const Scenario& scenario, const Outcome& outcome,
                           const RunReportOptions& options, const FrameGallery& gallery) {
  ScenarioReport report = scenario_report(scenario, outcome);
  report.gallery = gallery;
  if (options.times) {
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
      {"report.json", json_text(report_json(scenario, outcome))},
      {"report.md", report_markdown(scenario, outcome)}};
  if (!estimate.empty()) {
    files.push_back(
        {kTrajectoryPlot, draw_trajectory(outcome.truth, estimate, scenario.score.align)});
  }
  return files;
}

/// Returns whether a folder has no visible files; a killed run leaves hidden ones.
bool is_visibly_empty(const fs::path& folder) {
  const std::vector<vo::FolderEntry> entries = vo::entries_of(folder);
  return std::all_of(entries.begin(), entries.end(),
                     [](const vo::FolderEntry& entry) { return entry.name.starts_with('.'); });
}

/// Returns whether a file is the report of a run of edvo.
bool is_report_of_run(const fs::path& file) {
  return fs::is_regular_file(file) &&
         vo::read_file(file, vo::kMaxDocumentBytes).starts_with("{\n  \"schema\": \"edvo.run\",");
}

/// Returns whether a run of edvo has begun in the folder, also one that was killed while it
/// replaced its sequence, or whose sequence was removed since.
bool holds_run(const fs::path& folder) {
  const fs::path sequence = folder / "sequence";
  return fs::exists(sequence / "sequence.toml") ||
         fs::exists(vo::StagedFolder::staging_of(sequence)) ||
         fs::exists(vo::partial_name(sequence)) || is_report_of_run(folder / "report.json");
}

/// Throws vo::Error if the folder holds files but no run of edvo's.
void require_own_folder(const fs::path& folder) {
  if (!fs::exists(folder)) {
    return;
  }
  vo::require(fs::is_directory(folder), folder.string(),
              ": is a file, expected a folder for the results");
  vo::require(holds_run(folder) || is_visibly_empty(folder), folder.string(),
              ": holds other files than edvo's, expected a folder for the results");
}

/// Returns an observer that calls both observers in turn; an empty one is skipped.
vo::FrameObserver in_turn(const vo::FrameObserver& first, const vo::FrameObserver& second) {
  return [first, second](const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                         const vo::Tracker& tracker, const vo::TrackingResult& result,
                         const vo::StageTimes& times) {
    for (const vo::FrameObserver& observe : {first, second}) {
      if (observe) {
        observe(frame, pyramid, tracker, result, times);
      }
    }
  };
}

/// Returns observers that call those of both in turn.
ScenarioObservers together(const ScenarioObservers& first, const ScenarioObservers& second) {
  return {.frame = in_turn(first.frame, second.frame),
          .map = [first, second](std::size_t frame, const vo::DepthMap& map,
                                 const vo::DepthImage& truth, const vo::SE3& T_world_host) {
            for (const MapObserver& observe : {first.map, second.map}) {
              if (observe) {
                observe(frame, map, truth, T_world_host);
              }
            }
          }};
}

/// Pictures drawn while a scenario runs: panels/ in mode rgbd, maps/ in modes mono and mapping, and
/// the gallery of the HTML report.
class RunPictures {
 public:
  RunPictures(const Scenario& scenario, const fs::path& folder, int every,
              const vo::OutputPolicy& policy, const vo::WaitObserver& waiting) {
    if (scenario.odometry.mode == OdometryMode::rgbd) {
      panels_.emplace(folder / "panels", every, policy, waiting);
      makes_panels_ = every > 0;
    } else {
      maps_.emplace(folder / "maps", every, policy, waiting);
      scale_ = map_scale(scenario.odometry);
    }
  }

  ScenarioObservers observers() {
    const vo::FrameObserver remember = [this](const vo::RgbdFrame& frame, const vo::FramePyramid&,
                                              const vo::Tracker&, const vo::TrackingResult&,
                                              const vo::StageTimes&) { time_ = frame.timestamp; };
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

  /// Returns the name of the folder of pictures; empty where none is made.
  std::string folder_name() const { return maps_ ? "maps" : makes_panels_ ? "panels" : ""; }

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
  bool makes_panels_ = false;
  std::optional<DepthOutput> maps_;
  MapScale scale_ = MapScale::metric;
  double time_ = 0;  ///< s, time of the current frame
  FrameGallery gallery_;
};

/// Removes what an earlier run with other options left in the folder and this one did not make:
/// pictures, as far as they are edvo's, and the plot of a trajectory.
void remove_earlier_results(const fs::path& folder, const std::vector<vo::NamedBytes>& files,
                            const std::string& pictures) {
  for (const char* name : {"panels", "maps"}) {
    if (name != pictures && fs::exists(folder / name)) {
      vo::require_replaceable(folder / name, vo::ExistingOutput::replace);
      vo::remove_tree(folder / name);
    }
  }
  const bool is_plotted = std::any_of(files.begin(), files.end(), [](const vo::NamedBytes& file) {
    return file.name == kTrajectoryPlot;
  });
  if (!is_plotted) {
    fs::remove(folder / kTrajectoryPlot);
  }
}

}  // namespace

Outcome run_and_report(const Scenario& scenario, const fs::path& folder,
                       const vo::OutputPolicy& policy, const RunReportOptions& options,
                       const RunProgress& progress, const ScenarioObservers& watching) {
  require_own_folder(folder);
  scenario.require_scene();
  vo::make_folder(folder);
  RunPictures pictures(scenario, folder, options.debug_images, policy,
                       [&] { progress.track(0, 0); });
  Outcome outcome =
      run_scenario(scenario, folder, policy, together(pictures.observers(), watching), progress);
  std::vector<vo::NamedBytes> files = result_files(scenario, outcome);
  files.push_back({"report.html", browser_report(scenario, outcome, options, pictures.gallery())});
  vo::write_results(folder, files, policy);
  pictures.commit(outcome);
  if (policy.existing == vo::ExistingOutput::replace) {
    remove_earlier_results(folder, files, pictures.folder_name());
  }
  return outcome;
}

}  // namespace tools
