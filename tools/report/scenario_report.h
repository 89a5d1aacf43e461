#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/pictures/frame_gallery.h"
#include "tools/report/repeat_command.h"
#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "vo/evaluation/evaluate.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

struct ReportedMetric {
  std::string name;            ///< metric name that ends in its unit
  double value = 0;            ///< measured value; NaN where it could not be measured
  std::optional<Bound> bound;  ///< the scenario's bound, if any
  bool holds = true;
};

struct ReportedOption {
  std::string key;
  std::string value;
  std::string preset;  ///< default value in the scenario's mode and preset
  std::string help;
};

/// Data that the HTML report shows of one scenario. What is unknown stays empty and is left out,
/// such as the truth of a real sequence. Of an outside tracker's frames, status and pose alone are
/// known.
struct ScenarioReport {
  std::string name;
  std::string why;      ///< which defects would violate the bounds
  std::string tracker;  ///< command of an outside tracker; empty for edvo's own
  RepeatCommand repeat;
  std::string problem;  ///< why there is no result, or another failure; empty on success
  std::vector<ReportedMetric> metrics;
  std::vector<std::string> notes;
  std::vector<ReportedOption> options;
  std::optional<vo::PinholeCamera> camera;
  vo::TrajectoryAlignment alignment = vo::TrajectoryAlignment::se3;  ///< for the absolute error
  vo::Trajectory truth;
  vo::Trajectory estimate;
  std::vector<vo::TrackingResult> frames;
  std::vector<vo::StageTimes> times;  ///< stage times of `frames`; diagnostic, differ between runs
  FrameGallery gallery;

  /// Entry of `report_data` that another process made of the run. Where it is set, what is not of
  /// the verdict is taken from it: options, frames, pictures, point cloud, times.
  std::shared_ptr<const nlohmann::ordered_json> data;

  bool passed() const;
};

/// Returns the report of a run of edvo's tracker, without times and gallery.
ScenarioReport scenario_report(const Scenario& scenario, const Outcome& outcome);

/// Returns the report of an outside tracker, given as to `edvo test --tracker`: without the options
/// of edvo's odometry.
ScenarioReport outside_report(const Scenario& scenario, const Outcome& outcome,
                              const std::string& tracker);

}  // namespace tools
