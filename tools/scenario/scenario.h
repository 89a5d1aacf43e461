#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "synth/path_planning/path_options.h"
#include "synth/rendering/renderer.h"
#include "synth/sensor/sensor.h"
#include "tools/depth/mapping_run.h"
#include "vo/evaluation/evaluate.h"
#include "vo/geometry/camera.h"
#include "vo/odometry/mono_options.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

/// What a metric must lie between.
struct Bound {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  bool contains(double value) const { return min <= value && value <= max; }  ///< false for NaN
};

struct SceneOptions {
  std::filesystem::path gltf;  ///< relative to the assets folder, or absolute
};

template <typename Visitor>
void visit_fields(Visitor& visit, SceneOptions& options) {
  visit("gltf", options.gltf, "scene, relative to the assets");
}

struct CameraOptions {
  int width = 640;      ///< px
  int height = 480;     ///< px
  double fov_deg = 60;  ///< deg, horizontal
  double depth_units_per_m = 5000;
  vo::Distortion distortion;

  vo::RgbdCamera camera() const;
};

template <typename Visitor>
void visit_fields(Visitor& visit, CameraOptions& options) {
  visit("width", options.width, "px");
  visit("height", options.height, "px");
  visit("fov_deg", options.fov_deg, "horizontal field of view, deg");
  visit("depth_units_per_m", options.depth_units_per_m, "value of a 16-bit depth pixel at 1 m");
  visit("distortion", options.distortion, "");
}

/// What is tested.
enum class OdometryMode {
  rgbd,     ///< the tracker, on depth images
  mono,     ///< the tracker on a map of its own making, as `edvo track --mode mono`
  mapping,  ///< the map alone, with true poses, as `edvo depth`
};

constexpr auto enum_names(OdometryMode) {
  return std::array{std::pair{OdometryMode::rgbd, "rgbd"}, std::pair{OdometryMode::mono, "mono"},
                    std::pair{OdometryMode::mapping, "mapping"}};
}

struct OdometryOptions {
  OdometryMode mode = OdometryMode::rgbd;                       ///< which of the options count
  vo::TrackerPreset preset = vo::TrackerPreset::best_measured;  ///< where `tracker` starts from
  vo::TrackerOptions tracker;
  vo::MonoOptions mono = vo::mono_options();
  MappingOptions mapping;

  void validate() const;  ///< throws vo::Error
};

/// Those of its mode.
template <typename Visitor>
void visit_fields(Visitor& visit, OdometryOptions& options) {
  visit("mode", options.mode, "what is tested");
  switch (options.mode) {
    case OdometryMode::rgbd:
      visit("preset", options.preset, "option values that the tracker's start from");
      visit("tracker", options.tracker, "");
      break;
    case OdometryMode::mono:
      visit("mono", options.mono, "");
      break;
    case OdometryMode::mapping:
      visit("mapping", options.mapping, "");
      break;
  }
}

/// What the options of a mode, and of a preset where the mode is rgbd, start from.
OdometryOptions odometry_defaults(OdometryMode mode, vo::TrackerPreset preset);

struct ScoreOptions {
  vo::TrajectoryAlignment align = vo::TrajectoryAlignment::se3;
  double interval = 1;  ///< s, of the relative error
};

template <typename Visitor>
void visit_fields(Visitor& visit, ScoreOptions& options) {
  visit("align", options.align, "what is fitted before the absolute error is taken");
  visit("interval", options.interval, "of the relative error, s");
}

/// What a run is judged by. Names end in their unit.
struct Metrics {
  double ate_rmse_m = 0;
  double ate_max_m = 0;
  double rpe_translation_rmse_m = 0;
  double rpe_rotation_rmse_deg = 0;
  double drift_percent = 0;  ///< distance of the last pose from the truth over the path's length
  double tracked_fraction = 0;
  double keyframes = 0;
  double nees_median = 0;          ///< squared errors over their covariances; 1 is calibrated
  double repeat_difference_m = 0;  ///< greatest distance of two runs' poses; measured if bounded

  // Of a map of its own making; those of depth are of the last map's confident hypotheses.
  double ate_percent = 0;             ///< ATE over the length of the tracked part of the path
  double scale_error_percent = 0;     ///< of a metric estimate's size against the truth's
  double scale_drift_percent = 0;     ///< from the first map's to the last map's, per 10 m of path
  double depth_error_percent = 0;     ///< median relative error of the inverse depth
  double depth_outliers_percent = 0;  ///< share that errs by more than 10 %
  double depth_nees = 0;              ///< squared errors over variances, mean without outliers
  double depth_density_fraction = 0;  ///< confident hypotheses of all edge pixels kept
};

template <typename Visitor>
void visit_fields(Visitor& visit, Metrics& metrics) {
  visit("ate_rmse_m", metrics.ate_rmse_m, "absolute trajectory error");
  visit("ate_max_m", metrics.ate_max_m, "greatest absolute error");
  visit("rpe_translation_rmse_m", metrics.rpe_translation_rmse_m, "relative error per interval");
  visit("rpe_rotation_rmse_deg", metrics.rpe_rotation_rmse_deg, "relative error per interval");
  visit("drift_percent", metrics.drift_percent, "end point error over path length");
  visit("tracked_fraction", metrics.tracked_fraction, "frames with a pose");
  visit("keyframes", metrics.keyframes, "frames that became a reference");
  visit("nees_median", metrics.nees_median, "squared errors over covariances; 1 is calibrated");
  visit("repeat_difference_m", metrics.repeat_difference_m, "of two runs; measured if bounded");
  visit("ate_percent", metrics.ate_percent, "mono: absolute error over path length");
  visit("scale_error_percent", metrics.scale_error_percent, "mono, metric: size against truth's");
  visit("scale_drift_percent", metrics.scale_drift_percent, "mono: of the map, per 10 m");
  visit("depth_error_percent", metrics.depth_error_percent, "mono: median of the last map");
  visit("depth_outliers_percent", metrics.depth_outliers_percent, "mono: beyond 10 %");
  visit("depth_nees", metrics.depth_nees, "mono: squared errors over variances; 1 is calibrated");
  visit("depth_density_fraction", metrics.depth_density_fraction, "mono: confident edge pixels");
}

/// The metrics by name, in the order of their fields.
std::vector<std::pair<std::string, double>> metric_values(const Metrics& metrics);

/// Metrics with the value that `value_of` gives for each name.
Metrics make_metrics(const std::function<double(const std::string& name)>& value_of);

/// One file of scenarios/: what is rendered, how it is tracked, and how good the result must be.
struct Scenario {
  std::filesystem::path file;
  std::string name;   ///< the file's stem
  std::string why;    ///< what would break its bounds
  bool slow = false;  ///< labelled so in CTest
  SceneOptions scene;
  CameraOptions camera;
  synth::PathOptions path;
  synth::RenderOptions render;
  synth::SensorOptions sensor;
  OdometryOptions odometry;
  ScoreOptions score;
  std::map<std::string, Bound> expect;  ///< by metric

  std::filesystem::path scene_file() const;  ///< relative scenes are in `assets` beside the folder
  synth::PathOptions resolved_path() const;  ///< relative files are in the scenario's folder
};

/// All but the bounds.
template <typename Visitor>
void visit_fields(Visitor& visit, Scenario& scenario) {
  visit("why", scenario.why, "what would break the bounds");
  visit("slow", scenario.slow, "whether quick test runs leave it out");
  visit("scene", scenario.scene, "");
  visit("camera", scenario.camera, "");
  visit("path", scenario.path, "");
  visit("render", scenario.render, "");
  visit("sensor", scenario.sensor, "");
  visit("odometry", scenario.odometry, "");
  visit("score", scenario.score, "");
}

/// `key = value` as a scenario file has it, keys dotted from its outermost table.
using Assignment = std::pair<std::string, std::string>;
using Assignments = std::vector<Assignment>;

/// Throws vo::Error as `file:line: unknown key 'sensor.exposre'; the nearest known key is ...`, or
/// as `--set key=value: ...` where that is in the `changes`, which come after the file.
Scenario load_scenario(const std::filesystem::path& path, const Assignments& changes = {});

/// The scenario with other random numbers: every `seed` but the tracker's is this much higher.
Scenario with_seed(const Scenario& scenario, int offset);

}  // namespace tools
