#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/pictures/frame_gallery.h"
#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "vo/evaluation/evaluate.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

struct ReportedMetric {
  std::string name;            ///< ends in its unit
  double value = 0;            ///< NaN where it could not be measured
  std::optional<Bound> bound;  ///< if the scenario has one
  bool holds = true;
};

struct ReportedOption {
  std::string key;
  std::string value;
  std::string preset;  ///< what it is when the scenario says nothing
  std::string help;
};

/// What the HTML report shows of one scenario. Whatever is not known stays empty, and the report
/// leaves it out: a tracker that is not ours gives no `frames`, a real sequence perhaps no truth.
struct ScenarioReport {
  std::string name;
  std::string why;      ///< what would break the bounds
  std::string command;  ///< repeats the run
  std::string problem;  ///< why there is no result, or what else is wrong: it has failed
  std::vector<ReportedMetric> metrics;
  std::vector<std::string> notes;
  std::vector<ReportedOption> options;
  std::optional<vo::PinholeCamera> camera;
  vo::TrajectoryAlignment alignment = vo::TrajectoryAlignment::se3;  ///< of the absolute error
  vo::Trajectory truth;
  vo::Trajectory estimate;
  std::vector<vo::TrackingResult> frames;
  std::vector<vo::StageTimes> times;  ///< diagnostic, of `frames`: with them reports of equal runs
                                      ///< differ
  FrameGallery gallery;

  bool passed() const;
};

/// All but times and gallery.
ScenarioReport scenario_report(const Scenario& scenario, const Outcome& outcome);

}  // namespace tools
