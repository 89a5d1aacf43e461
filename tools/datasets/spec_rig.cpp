#include "tools/datasets/spec_rig.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "synth/rig/camera_jobs.h"
#include "tools/datasets/part_folder.h"
#include "vo/core/error.h"
#include "vo/rigs/rig_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// Returns the value with which a spec names its rig.
const vo::TomlValue& rig_value(const DatasetSpec& spec) {
  return *std::find_if(spec.values.begin(), spec.values.end(),
                       [](const vo::TomlValue& value) { return value.key == "rig"; });
}

/// Returns a key of [sensor] or [sensors.NAME] as the table has it; empty for others.
std::string_view key_in_sensor(std::string_view key) {
  for (const std::string_view table : {"sensor.", "sensors."}) {
    if (key.starts_with(table)) {
      key.remove_prefix(table == "sensor." ? table.size() : key.find('.', table.size()) + 1);
      return key;
    }
  }
  return {};
}

bool has_sensor_key(const vo::RigCamera& camera, std::string_view key) {
  return std::any_of(camera.sensor.begin(), camera.sensor.end(),
                     [&](const vo::TomlValue& value) { return value.key == key; });
}

/// Throws vo::Error for values that say what the rig says.
void require_no_cameras(const DatasetSpec& spec) {
  for (const vo::TomlValue& value : spec.values) {
    vo::require(
        !value.key.starts_with("camera.") && !key_in_sensor(value.key).starts_with("camera."),
        value.place, ": ", value.key, ": expected none beside rig, whose file has cameras");
  }
}

/// Throws vo::Error for options of sensors that change no camera, since a preset resets them.
void require_effect(const DatasetSpec& spec) {
  const std::set<std::string_view> without_effect_on_noise{"", "seed", "scenes", "paths"};
  const bool all_have_presets =
      std::all_of(spec.rig->cameras.begin(), spec.rig->cameras.end(),
                  [](const vo::RigCamera& camera) { return has_sensor_key(camera, "preset"); });
  for (const vo::TomlValue& value : spec.values) {
    vo::require(!all_have_presets || without_effect_on_noise.contains(key_in_sensor(value.key)),
                value.place, ": ", value.key,
                ": changes nothing, every camera of the rig has a sensor.preset of its own; "
                "expected a rig with a camera without one");
  }
}

/// Throws vo::Error where sequences that differ by their seed alone would have the same noise.
void require_own_noise(const DatasetSpec& spec) {
  for (const vo::RigCamera& camera : spec.rig->cameras) {
    vo::require(spec.options.seeds == 1 || !has_sensor_key(camera, "seed"), vo::describe(camera),
                ": sensor.seed: expected none where a data set has seeds = ", spec.options.seeds,
                ", whose sequences each have noise of their own");
  }
}

void require_formats_of_rigs(const DatasetSpec& spec) {
  const bool has_pinhole =
      std::any_of(spec.rig->cameras.begin(), spec.rig->cameras.end(),
                  [](const vo::RigCamera& camera) { return camera.camera.model.pinhole(); });
  vo::require(has_pinhole || spec.formats().empty(), spec.file.string(),
              ": formats: expected a camera of the rig that is a pinhole, which euroc holds alone");
  for (const vo::WrittenSequence format : spec.formats()) {
    vo::require(format == vo::WrittenSequence::euroc, spec.file.string(),
                ": formats: ", vo::to_string(format),
                ": holds one camera, expected euroc alone beside rig");
  }
}

/// Returns a job of a body at rest, to see whether a rig's cameras can be rendered.
synth::RigJob resting(const DatasetSpec& spec, const Scenario& scenario) {
  synth::RigJob job{*spec.rig, {}};
  job.body.recipe.path = [](double /*time*/) { return vo::SE3(); };
  job.body.recipe.sensor = scenario.sensor;
  job.body.recipe.render = scenario.render;
  job.body.recipe.channels = scenario.truth();
  job.body.recipe.channels.channels = spec.channels();
  return job;
}

}  // namespace

void read_spec_rig(DatasetSpec& spec) {
  if (spec.options.rig.empty()) {
    return;
  }
  const std::string& place = rig_value(spec).place;
  const fs::path file = spec.rig_file();
  vo::require(path_exists(file), place, ": rig: ", file.string(),
              " does not exist, expected the file of a rig");
  try {
    spec.rig = vo::read_rig(file);
    require_own_noise(spec);
  } catch (const vo::Error& error) {
    vo::fail(place, ": rig: ", error.what());
  }
  require_no_cameras(spec);
  require_effect(spec);
  require_formats_of_rigs(spec);
}

void require_usable_rig(const DatasetSpec& spec) {
  if (!spec.rig) {
    return;
  }
  std::set<std::string> sensors;
  for (const DatasetSequence& sequence : spec.sequences) {
    if (!sensors.insert(sequence.sensor).second) {
      continue;
    }
    try {
      synth::camera_jobs(resting(spec, sequence.scenario));
    } catch (const vo::Error& error) {
      vo::fail(rig_value(spec).place, ": rig: ", error.what());
    }
  }
}

std::uint64_t sensor_seed_offset(const DatasetSpec& spec, int seed) {
  return static_cast<std::uint64_t>(seed) * spec.camera_count();
}

}  // namespace tools
