#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "synth/gltf/actor.h"
#include "synth/gltf/gltf.h"
#include "synth/path_planning/path_options.h"
#include "synth/rendering/renderer.h"
#include "synth/sensor/sensor.h"
#include "synth/truth/truth_channels.h"
#include "tools/depth/mapping_run.h"
#include "vo/evaluation/evaluate.h"
#include "vo/geometry/camera.h"
#include "vo/odometry/mono_options.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/text_files/toml_file.h"

namespace tools {

/// A closed interval that a metric must lie in.
struct Bound {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  bool contains(double value) const { return min <= value && value <= max; }  ///< false for NaN
};

struct SceneOptions {
  std::filesystem::path gltf;  ///< relative to the assets folder, or absolute
  synth::GltfOptions parts;    ///< what of the file is read: its scene, its animations
};

template <typename Visitor>
void visit_fields(Visitor& visit, SceneOptions& options) {
  visit("gltf", options.gltf, "scene, relative to the assets");
  visit_fields(visit, options.parts);
}

struct CameraOptions {
  int width = 640;      ///< px
  int height = 480;     ///< px
  double fov_deg = 60;  ///< horizontal field of view, deg
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

/// The part of the odometry that a scenario tests.
enum class OdometryMode {
  rgbd,     ///< tracking with depth images
  mono,     ///< monocular tracking and mapping, as `edvo track --mode mono`
  mapping,  ///< mapping alone, with true poses, as `edvo depth`
};

constexpr auto enum_names(OdometryMode) {
  return std::array{std::pair{OdometryMode::rgbd, "rgbd"}, std::pair{OdometryMode::mono, "mono"},
                    std::pair{OdometryMode::mapping, "mapping"}};
}

struct OdometryOptions {
  OdometryMode mode = OdometryMode::rgbd;  ///< selects which of the options apply
  vo::TrackerPreset preset = vo::TrackerPreset::best_measured;  ///< preset of `tracker`
  vo::TrackerOptions tracker;
  vo::MonoOptions mono = vo::mono_options();
  MappingOptions mapping;

  void validate() const;  ///< throws vo::Error on an invalid option of the mode
};

/// Visits the mode and the options that apply in it.
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

/// Returns the default options of a mode; in mode rgbd the tracker's are those of the preset.
OdometryOptions odometry_defaults(OdometryMode mode, vo::TrackerPreset preset);

struct ScoreOptions {
  vo::TrajectoryAlignment align = vo::TrajectoryAlignment::se3;
  double interval = 1;  ///< interval of the relative pose error, s
};

template <typename Visitor>
void visit_fields(Visitor& visit, ScoreOptions& options) {
  visit("align", options.align, "what is fitted before the absolute error is taken");
  visit("interval", options.interval, "of the relative error, s");
}

/// Metrics that a run is evaluated by. Names end in their unit.
struct Metrics {
  double ate_rmse_m = 0;
  double ate_max_m = 0;
  double rpe_translation_rmse_m = 0;
  double rpe_rotation_rmse_deg = 0;
  double drift_percent = 0;  ///< distance of the last pose from the truth over the path's length
  double tracked_fraction = 0;
  double keyframes = 0;
  double nees_median = 0;           ///< NEES of poses relative to their references; 1 is calibrated
  double nees_p90 = 0;              ///< tail of the same, at the 90th percentile
  double nees_absolute_median = 0;  ///< NEES of poses relative to the first frame
  double nees_absolute_p90 = 0;     ///< tail of the same, at the 90th percentile
  double sure_error_max_m = 0;      ///< greatest error since the first frame of a pose not in doubt
  double repeat_difference_m = 0;   ///< greatest distance between two runs; only if bounded

  // Metrics of modes mono and mapping; those of depth use the last map's confident hypotheses.
  double ate_percent = 0;             ///< ATE over the length of the tracked part of the path
  double scale_error_percent = 0;     ///< |scale error| of a metric estimate
  double scale_drift_percent = 0;     ///< |scale change| from first to last map, per 10 m
  double depth_error_percent = 0;     ///< median relative error of the inverse depth
  double depth_outliers_percent = 0;  ///< share with a relative error beyond 10 %
  double depth_nees = 0;              ///< NEES of the inverse depth without outliers
  double depth_density_fraction = 0;  ///< share of hypotheses that are confident
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
  visit("nees_p90", metrics.nees_p90, "the same in the tail, at the 90th percentile");
  visit("nees_absolute_median", metrics.nees_absolute_median, "of poses since the first frame");
  visit("nees_absolute_p90", metrics.nees_absolute_p90, "the same in the tail");
  visit("sure_error_max_m", metrics.sure_error_max_m, "greatest, of poses not called uncertain");
  visit("repeat_difference_m", metrics.repeat_difference_m, "of two runs; measured if bounded");
  visit("ate_percent", metrics.ate_percent, "mono: absolute error over path length");
  visit("scale_error_percent", metrics.scale_error_percent, "mono, metric: size against truth's");
  visit("scale_drift_percent", metrics.scale_drift_percent, "mono: of the map, per 10 m");
  visit("depth_error_percent", metrics.depth_error_percent, "mono: median of the last map");
  visit("depth_outliers_percent", metrics.depth_outliers_percent, "mono: beyond 10 %");
  visit("depth_nees", metrics.depth_nees, "mono: squared errors over variances; 1 is calibrated");
  visit("depth_density_fraction", metrics.depth_density_fraction, "mono: confident edge pixels");
}

/// Returns the metrics' names and values in the order of their fields.
std::vector<std::pair<std::string, double>> metric_values(const Metrics& metrics);

/// Returns metrics with the values that `value_of` gives for each name.
Metrics make_metrics(const std::function<double(const std::string& name)>& value_of);

/// Returns the metrics with those unknown (NaN) that judge what a tracker says of its own poses:
/// their covariances and which of them are uncertain.
Metrics without_own_judgement(const Metrics& metrics);

/// A scenario file: what is rendered, how it is tracked, and which bounds, if any, the metrics must
/// meet.
struct Scenario {
  std::filesystem::path file;
  std::string name;                          ///< the file's stem
  std::string why;                           ///< what would break its bounds
  bool slow = false;                         ///< labelled slow in CTest
  std::string channels;                      ///< exact ground truth, as parse_channels takes it
  std::vector<synth::SurfaceClass> classes;  ///< of the file's tables [[class]]
  std::vector<synth::ActorOptions> actors;   ///< of the file's tables [[actor]]
  SceneOptions scene;
  CameraOptions camera;
  synth::PathOptions path;
  synth::RenderOptions render;
  synth::SensorOptions sensor;
  OdometryOptions odometry;
  ScoreOptions score;
  std::map<std::string, Bound> expect;  ///< bounds by metric; empty if others judge

  std::filesystem::path scene_file() const;   ///< relative to ../assets of the file's folder
  void require_scene() const;                 ///< throws vo::Error unless the scene's file exists
  synth::TruthOptions truth() const;          ///< its channels and classes
  synth::PathOptions resolved_path() const;   ///< path with its file relative to the scenario's
  synth::GltfOptions resolved_parts() const;  ///< scene.parts, its environment as the scene's file
};

/// Visits all fields of a scenario file except the bounds, classes and actors.
template <typename Visitor>
void visit_fields(Visitor& visit, Scenario& scenario) {
  visit("why", scenario.why, "what would break the bounds");
  visit("slow", scenario.slow, "whether quick test runs leave it out");
  visit("channels", scenario.channels, "exact ground truth to write, as edvo render --channels");
  visit("scene", scenario.scene, "");
  visit("camera", scenario.camera, "");
  visit("path", scenario.path, "");
  visit("render", scenario.render, "");
  visit("sensor", scenario.sensor, "");
  visit("odometry", scenario.odometry, "");
  visit("score", scenario.score, "");
}

/// A `key = value` assignment of a scenario file, with the dotted key from the outermost table.
using Assignment = std::pair<std::string, std::string>;
using Assignments = std::vector<Assignment>;

/// Returns whether a path is a scenario's: a file .toml, or stdin.
bool names_scenario(const std::filesystem::path& path);

/// Returns the scenario that a file's values make with `changes`; of values with one key the last
/// counts. Names in one of stdin are as if it lay in the working folder. Throws vo::Error as
/// `file:line: unknown key 'sensor.exposre'; ...`, without a line where no value of the file is at
/// fault, or as `--set key=value: ...` if the error is in
/// the changes.
Scenario make_scenario(const std::vector<vo::TomlValue>& values, const std::filesystem::path& file,
                       const Assignments& changes = {});

/// Loads a scenario and applies `changes`; throws as `make_scenario` does.
Scenario load_scenario(const std::filesystem::path& path, const Assignments& changes = {});

/// Returns the scenario with `offset` added to every `seed` except those of the odometry.
Scenario with_seed(const Scenario& scenario, int offset);

}  // namespace tools
