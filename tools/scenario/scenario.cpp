#include "tools/scenario/scenario.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "synth/environment/environment.h"
#include "synth/sensor/preset.h"
#include "tools/scenario/actor_tables.h"
#include "tools/scenario/class_tables.h"
#include "tools/scenario/value_places.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/input.h"
#include "vo/text_files/toml_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExpect = "expect.";

/// Returns the fields `expect.<metric>.min` and `.max` of every metric.
std::vector<vo::Field> bound_fields(std::map<std::string, Bound>& bounds) {
  Metrics metrics;
  std::vector<vo::Field> fields;
  for (const vo::Field& metric : vo::fields_of(metrics)) {
    const auto add = [&](const char* side, double Bound::*limit) {
      fields.push_back({std::string(kExpect) + metric.key + side, metric.help, vo::FieldType::real,
                        [] { return std::string(); },
                        [&bounds, key = metric.key, limit](std::string_view text) {
                          bounds[key].*limit = vo::parse_real(text);
                        }});
    };
    add(".min", &Bound::min);
    add(".max", &Bound::max);
  }
  return fields;
}

/// Returns the folder that names in a scenario start from: its own, or for one of stdin the
/// working folder.
fs::path folder_of(const fs::path& file) {
  return file == vo::kStdinPath ? fs::current_path() : fs::absolute(file).parent_path();
}

/// Returns the folder that the scenes of a scenario are in.
fs::path assets_of(const fs::path& file) {
  return folder_of(file) / ".." / "assets";
}

void apply(const Assignments& changes, std::vector<vo::Field>& fields) {
  for (const auto& [key, value] : changes) {
    try {
      vo::set_field(fields, key, value);
    } catch (const vo::Error& error) {
      vo::fail_as(vo::ErrorKind::usage, "--set ", key, "=", value, ": ", error.what());
    }
  }
}

/// Applies one option that determines the defaults of others: the file's value, then the changes'.
template <typename Options>
void apply_first(const std::string& key, const std::vector<vo::TomlValue>& values,
                 const Assignments& changes, Options& options) {
  const std::string prefix = key.substr(0, key.find('.') + 1);
  std::vector<vo::Field> fields = vo::fields_of(options, prefix);
  for (const vo::TomlValue& value : values) {
    if (value.key == key) {
      vo::assign_fields({value}, fields);
    }
  }
  for (const Assignment& change : changes) {
    if (change.first == key) {
      apply({change}, fields);
    }
  }
}

/// Applies the sensor preset, which must precede the options that it determines.
void apply_preset(const std::vector<vo::TomlValue>& values, const Assignments& changes,
                  synth::SensorOptions& sensor) {
  apply_first("sensor.preset", values, changes, sensor);
  sensor = synth::preset_options(sensor.preset);
}

/// Applies the mode, which determines the available options, and the preset, which determines their
/// defaults, before all others.
void apply_start(const std::vector<vo::TomlValue>& values, const Assignments& changes,
                 OdometryOptions& odometry) {
  for (const std::string key : {"odometry.mode", "odometry.preset"}) {
    apply_first(key, values, changes, odometry);
    odometry = odometry_defaults(odometry.mode, odometry.preset);
  }
}

fs::path resolved(const fs::path& file, const fs::path& folder) {
  return file.empty() || file.is_absolute() ? file : (folder / file).lexically_normal();
}

class ValueCollector {
 public:
  void operator()(const char* name, double& value, const char* /*help*/) {
    values.emplace_back(name, value);
  }

  std::vector<std::pair<std::string, double>> values;
};

class ValueSetter {
 public:
  explicit ValueSetter(const std::function<double(const std::string&)>& value_of)
      : value_of_(value_of) {}

  void operator()(const char* name, double& value, const char* /*help*/) {
    value = value_of_(name);
  }

 private:
  const std::function<double(const std::string&)>& value_of_;
};

/// Returns the place of what an error's message is about, or the file where a change may be at
/// fault.
std::string place_at_fault(const std::string& message, const std::vector<vo::TomlValue>& values,
                           const fs::path& file, const Assignments& changes) {
  const bool is_changed = std::any_of(changes.begin(), changes.end(), [&](const Assignment& one) {
    return is_about(message, one.first);
  });
  return is_changed ? file.string() : place_of(message, values, file);
}

void validate(const Scenario& scenario) {
  vo::require(!scenario.why.empty() || scenario.expect.empty(),
              "why: expected a sentence on what would break the bounds");
  vo::require(!scenario.scene.gltf.empty(), "scene.gltf: expected a scene");
  for (const auto& [metric, bound] : scenario.expect) {
    vo::require(bound.min <= bound.max, "expect.", metric, ": expected min <= max");
  }
  scenario.truth().validate();
  scenario.camera.camera().validate();
  scenario.path.validate();
  scenario.render.validate();
  scenario.sensor.validate();
  scenario.odometry.validate();
  vo::require(scenario.score.interval > 0, "score.interval: expected above 0, got ",
              scenario.score.interval);
}

}  // namespace

void OdometryOptions::validate() const {
  switch (mode) {
    case OdometryMode::rgbd:
      tracker.validate();
      break;
    case OdometryMode::mono:
      mono.validate();
      vo::require(mono.bootstrap != vo::MonoBootstrap::file,
                  "odometry.mono.bootstrap: expected rgbd, flat, random or auto, a scenario has no "
                  "depth file");
      break;
    case OdometryMode::mapping:
      mapping.validate();
      break;
  }
}

OdometryOptions odometry_defaults(OdometryMode mode, vo::TrackerPreset preset) {
  OdometryOptions options;
  options.mode = mode;
  options.preset = preset;
  options.tracker = vo::preset_options(preset);
  return options;
}

vo::RgbdCamera CameraOptions::camera() const {
  vo::RgbdCamera result{vo::PinholeCamera::from_horizontal_fov(width, height, fov_deg),
                        depth_units_per_m};
  result.pinhole.distortion = distortion;
  return result;
}

std::vector<std::pair<std::string, double>> metric_values(const Metrics& metrics) {
  Metrics copy = metrics;
  ValueCollector collector;
  visit_fields(collector, copy);
  return collector.values;
}

Metrics without_own_judgement(const Metrics& metrics) {
  const std::vector<std::pair<std::string, double>> values = metric_values(metrics);
  return make_metrics([&](const std::string& name) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const auto& value) { return value.first == name; });
    const bool is_own = name.starts_with("nees_") || name == "sure_error_max_m";
    return is_own ? std::numeric_limits<double>::quiet_NaN() : found->second;
  });
}

Metrics make_metrics(const std::function<double(const std::string& name)>& value_of) {
  Metrics metrics;
  ValueSetter setter(value_of);
  visit_fields(setter, metrics);
  return metrics;
}

bool names_scenario(const fs::path& path) {
  return path.extension() == ".toml" || path == vo::kStdinPath;
}

fs::path Scenario::scene_file() const {
  return resolved(scene.gltf, assets_of(file));
}

void Scenario::require_scene() const {
  vo::require(std::filesystem::exists(scene_file()), file.string(),
              ": scene.gltf: ", scene_file().string(), ": there is no such file");
}

synth::TruthOptions Scenario::truth() const {
  return {.channels = channels.empty() ? std::vector<synth::TruthChannel>()
                                       : synth::parse_channels(channels),
          .classes = classes};
}

synth::PathOptions Scenario::resolved_path() const {
  synth::PathOptions result = path;
  result.file = resolved(path.file, folder_of(file));
  result.file_times = resolved(path.file_times, folder_of(file));
  return result;
}

synth::GltfOptions Scenario::resolved_parts() const {
  synth::GltfOptions result = scene.parts;
  if (synth::is_environment_file(result.environment)) {
    result.environment = resolved(result.environment, assets_of(file)).string();
  }
  return result;
}

Scenario make_scenario(const std::vector<vo::TomlValue>& values, const fs::path& file,
                       const Assignments& changes) {
  Scenario scenario;
  scenario.file = file;
  scenario.name = file.stem().string();
  apply_preset(values, changes, scenario.sensor);
  apply_start(values, changes, scenario.odometry);

  std::vector<vo::Field> fields = vo::fields_of(scenario);
  for (vo::Field& field : bound_fields(scenario.expect)) {
    fields.push_back(std::move(field));
  }
  std::vector<vo::TomlValue> of_fields = values;
  scenario.classes = take_classes(of_fields);
  scenario.actors = take_actors(of_fields, assets_of(file));
  vo::assign_fields(of_fields, fields);
  apply(changes, fields);

  try {
    validate(scenario);
  } catch (const vo::Error& error) {
    vo::fail(place_at_fault(error.what(), values, file, changes), ": ", error.what());
  }
  return scenario;
}

Scenario load_scenario(const fs::path& path, const Assignments& changes) {
  return make_scenario(vo::read_toml(path), path, changes);
}

Scenario with_seed(const Scenario& scenario, int offset) {
  Scenario result = scenario;
  for (const vo::Field& field : vo::fields_of(result)) {
    const bool is_seed = field.key.ends_with(".seed") && !field.key.starts_with("odometry.");
    if (is_seed) {
      field.set(std::to_string(vo::parse_integer(field.get()) + offset));
    }
  }
  return result;
}

}  // namespace tools
