#include "tools/datasets/spec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "synth/environment/environment.h"
#include "tools/datasets/name_list.h"
#include "tools/datasets/part_folder.h"
#include "tools/datasets/spec_actors.h"
#include "tools/datasets/spec_rig.h"
#include "tools/scenario/value_places.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// The tables of a spec that are as in a scenario.
constexpr std::array<std::string_view, 6> kScenarioTables{"camera.", "render.", "path.",
                                                          "sensor.", "class.",  "actor."};

/// A named scene, path or sensor of a spec.
struct Alternative {
  std::string name;
  std::vector<vo::TomlValue> values;                    ///< keys as in a scenario
  std::map<std::string, std::string, std::less<>> own;  ///< texts of keys that a scenario lacks
  std::string place;                                    ///< of its first value, for messages
};

/// A kind of alternatives: their table, what their keys are in a scenario, and the keys that only a
/// spec has.
struct Kind {
  std::string_view table;
  std::string_view prefix;
  std::vector<std::string_view> own;
};

const Kind& scene_kind() {
  static const Kind kind{"scenes.", "scene.", {"split", "licence"}};
  return kind;
}

const Kind& path_kind() {
  static const Kind kind{"paths.", "path.", {"scenes"}};
  return kind;
}

const Kind& sensor_kind() {
  static const Kind kind{"sensors.", "sensor.", {"scenes", "paths"}};
  return kind;
}

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  });
}

/// Adds a value of an alternative; `key` is within the alternative's table.
void add_value(const Kind& kind, const vo::TomlValue& value, std::string_view key,
               Alternative& alternative) {
  if (std::find(kind.own.begin(), kind.own.end(), key) != kind.own.end()) {
    vo::require(value.type == vo::FieldType::text, value.place, ": ", value.key,
                ": expected a text in quotes");
    alternative.own.emplace(key, value.text);
    return;
  }
  vo::TomlValue scenario_value = value;
  const bool is_camera = kind.prefix == "sensor." && key.starts_with("camera.");
  scenario_value.key = (is_camera ? "" : std::string(kind.prefix)) + std::string(key);
  alternative.values.push_back(std::move(scenario_value));
}

/// What a spec's file holds.
struct SpecFile {
  fs::path path;
  const std::vector<vo::TomlValue>& values;
  std::vector<vo::TomlTable> tables;
};

/// Returns the alternatives of a kind, sorted by name.
std::vector<Alternative> alternatives_of(const Kind& kind, const SpecFile& file) {
  std::vector<Alternative> alternatives;
  for (const vo::TomlTable& table : file.tables) {
    const std::string name = table.key.substr(std::min(kind.table.size(), table.key.size()));
    if (!table.key.starts_with(kind.table) || name.find('.') != std::string::npos) {
      continue;
    }
    vo::require(is_name(name), table.place, ": ", table.key,
                ": expected a name of letters, digits and -");
    Alternative alternative{.name = name, .place = table.place};
    const std::string prefix = table.key + ".";
    for (const vo::TomlValue& value : file.values) {
      if (value.key.starts_with(prefix)) {
        add_value(kind, value, std::string_view(value.key).substr(prefix.size()), alternative);
      }
    }
    alternatives.push_back(std::move(alternative));
  }
  return alternatives;
}

/// Returns whether an alternative goes with another of the kind that its list `key` names.
bool goes_with(const Alternative& alternative, std::string_view key, const std::string& name) {
  const auto list = alternative.own.find(key);
  if (list == alternative.own.end()) {
    return true;
  }
  const std::vector<std::string> names = names_in(list->second);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Throws vo::Error where a list of names has one that is none of the alternatives'.
void require_known(const std::vector<Alternative>& with_lists, std::string_view key,
                   const std::vector<Alternative>& named) {
  for (const Alternative& alternative : with_lists) {
    const auto list = alternative.own.find(key);
    for (const std::string& name : names_in(list == alternative.own.end() ? "" : list->second)) {
      const bool is_known = std::any_of(named.begin(), named.end(),
                                        [&](const Alternative& a) { return a.name == name; });
      vo::require(is_known, alternative.place, ": ", alternative.name, ".", key, ": there is no '",
                  name, "'");
    }
  }
}

/// Throws vo::Error where an actor goes through a scene that there is not.
void require_known(const std::vector<SpecActor>& actors, const std::vector<Alternative>& scenes) {
  for (const SpecActor& actor : actors) {
    for (const std::string& name : actor.scenes) {
      const bool is_known = std::any_of(scenes.begin(), scenes.end(),
                                        [&](const Alternative& a) { return a.name == name; });
      vo::require(is_known, actor.place, ": actor.scenes: there is no '", name, "'");
    }
  }
}

std::string own_text(const Alternative& alternative, std::string_view key,
                     const std::string& otherwise) {
  const auto text = alternative.own.find(key);
  return text == alternative.own.end() ? otherwise : text->second;
}

/// Makes the files of a scene absolute, as seen from the spec's folder.
void resolve_scene(const fs::path& spec, Alternative& scene) {
  for (vo::TomlValue& value : scene.values) {
    const bool is_environment_file =
        value.key == "scene.environment" && synth::is_environment_file(value.text);
    if (value.key == "scene.gltf" || is_environment_file) {
      value.text = (fs::absolute(spec).parent_path() / value.text).lexically_normal().string();
    }
  }
}

/// All that sequences of a spec are combined of.
struct Alternatives {
  std::vector<vo::TomlValue> common;  ///< values of all sequences
  std::vector<SpecActor> actors;
  std::vector<Alternative> scenes;
  std::vector<Alternative> paths;
  std::vector<Alternative> sensors;  ///< one without a name where the spec has none
};

Alternatives read_alternatives(const SpecFile& file) {
  Alternatives all;
  for (const vo::TomlValue& value : file.values) {
    const bool is_common =
        std::any_of(kScenarioTables.begin(), kScenarioTables.end(),
                    [&](std::string_view table) { return value.key.starts_with(table); });
    if (is_common) {
      all.common.push_back(value);
    }
  }
  all.actors = take_spec_actors(all.common, file.path);
  all.scenes = alternatives_of(scene_kind(), file);
  all.paths = alternatives_of(path_kind(), file);
  all.sensors = alternatives_of(sensor_kind(), file);
  vo::require(!all.scenes.empty(), file.path.string(),
              ": expected a scene, [scenes.NAME] with gltf");
  vo::require(!all.paths.empty(), file.path.string(), ": expected a path, [paths.NAME] with kind");
  require_known(all.paths, "scenes", all.scenes);
  require_known(all.sensors, "scenes", all.scenes);
  require_known(all.sensors, "paths", all.paths);
  require_known(all.actors, all.scenes);
  if (all.sensors.empty()) {
    all.sensors.emplace_back();
  }
  for (Alternative& scene : all.scenes) {
    resolve_scene(file.path, scene);
  }
  return all;
}

/// One scene, path and sensor of a spec.
struct Combination {
  const Alternative& scene;
  const Alternative& path;
  const Alternative& sensor;

  bool is_wanted() const {
    return goes_with(path, "scenes", scene.name) && goes_with(sensor, "scenes", scene.name) &&
           goes_with(sensor, "paths", path.name);
  }
};

/// Adds the sequences of a combination, one for each seed.
void add_sequences(const Combination& combination, const Alternatives& all, DatasetSpec& spec) {
  std::vector<vo::TomlValue> values = all.common;
  for (const Alternative* part : {&combination.scene, &combination.path, &combination.sensor}) {
    values.insert(values.end(), part->values.begin(), part->values.end());
  }
  for (const SpecActor& actor : all.actors) {
    if (actor.goes_through(combination.scene.name)) {
      values.insert(values.end(), actor.values.begin(), actor.values.end());
    }
  }
  const Scenario scenario = make_scenario(values, spec.file);
  for (int seed = 0; seed < spec.options.seeds; ++seed) {
    DatasetSequence sequence{.scene = combination.scene.name,
                             .path = combination.path.name,
                             .sensor = combination.sensor.name,
                             .seed = seed,
                             .split = own_text(combination.scene, "split", "train"),
                             .licence = own_text(combination.scene, "licence", "not stated"),
                             .scenario = with_seed(scenario, seed)};
    sequence.scenario.sensor.seed = scenario.sensor.seed + sensor_seed_offset(spec, seed);
    vo::require(is_name(sequence.split), combination.scene.place, ": scenes.", sequence.scene,
                ".split: expected letters, digits and -, got '", sequence.split, "'");
    sequence.name = vo::concat(sequence.scene, "_", sequence.path, "_",
                               sequence.sensor.empty() ? "" : sequence.sensor + "_", seed);
    sequence.scenario.name = sequence.name;
    spec.sequences.push_back(std::move(sequence));
  }
}

/// Adds the sequences of a scene with a path, by every sensor that goes with them.
void add_sequences_along(const Alternative& scene, const Alternative& path, const Alternatives& all,
                         DatasetSpec& spec) {
  for (const Alternative& sensor : all.sensors) {
    const Combination combination{scene, path, sensor};
    if (combination.is_wanted()) {
      add_sequences(combination, all, spec);
    }
  }
}

void add_all_sequences(const Alternatives& all, DatasetSpec& spec) {
  for (const Alternative& scene : all.scenes) {
    for (const Alternative& path : all.paths) {
      add_sequences_along(scene, path, all, spec);
    }
  }
  vo::require(!spec.sequences.empty(), spec.file.string(),
              ": no scene, path and sensor go together, expected at least one sequence");
}

/// Sets the options of a spec and its filter; every other key must be of a table of scenarios or of
/// alternatives.
void read_options(DatasetSpec& spec) {
  std::vector<vo::Field> fields = vo::fields_of(spec.options);
  for (vo::Field& field : vo::fields_of(spec.filter, "filter.")) {
    fields.push_back(std::move(field));
  }
  std::vector<vo::TomlValue> own;
  const auto is_elsewhere = [](const std::string& key) {
    const auto begins = [&](std::string_view table) { return key.starts_with(table); };
    return std::any_of(kScenarioTables.begin(), kScenarioTables.end(), begins) ||
           begins(scene_kind().table) || begins(path_kind().table) || begins(sensor_kind().table);
  };
  std::copy_if(spec.values.begin(), spec.values.end(), std::back_inserter(own),
               [&](const vo::TomlValue& value) { return !is_elsewhere(value.key); });
  vo::assign_fields(own, fields);
  if (spec.options.name.empty()) {
    spec.options.name = spec.file.stem().string();
  }
  const ValuesOfFile values{spec.file, own};
  values.require_valid("", [&] { spec.options.validate(); });
  values.require_valid("filter: ", [&] { spec.filter.validate(); });
  values.require_valid("channels: ", [&] { spec.channels(); });
  values.require_valid("formats: ", [&] { spec.formats(); });
}

/// Throws vo::Error if there is a channel of classes without a class.
void require_classes(const DatasetSpec& spec) {
  synth::TruthOptions truth = spec.sequences.front().scenario.truth();
  truth.channels = spec.channels();
  if (spec.rig) {
    std::erase_if(truth.channels, synth::is_of_pair);  // which some of its cameras have
  }
  ValuesOfFile{spec.file, spec.values}.require_valid("", [&] { truth.validate(); });
}

/// Throws vo::Error that names all files of scenes and actors that are missing.
void require_scenes(const DatasetSpec& spec) {
  std::set<std::string> missing;
  const auto look = [&](const std::string& key, const fs::path& file) {
    if (!path_exists(file)) {
      missing.insert(vo::concat(key, ": ", file.string(), " does not exist"));
    }
  };
  for (const DatasetSequence& sequence : spec.sequences) {
    look(vo::concat("scenes.", sequence.scene, ".gltf"), sequence.scenario.scene_file());
    for (const synth::ActorOptions& actor : sequence.scenario.actors) {
      look("actor.file", actor.file);
    }
  }
  std::string sentence;
  for (const std::string& one : missing) {
    sentence += (sentence.empty() ? "" : "; ") + one;
  }
  vo::require(missing.empty(), spec.file.string(), ": ", sentence);
}

}  // namespace

bool DatasetFilter::is_empty() const {
  DatasetFilter copy = *this;
  DatasetFilter none;
  const std::vector<vo::Field> given = vo::fields_of(copy);
  const std::vector<vo::Field> defaults = vo::fields_of(none);
  return std::equal(given.begin(), given.end(), defaults.begin(),
                    [](const vo::Field& a, const vo::Field& b) { return a.get() == b.get(); });
}

void DatasetFilter::validate() const {
  limits.validate();
  for (const double limit : {min_mean_flow_px, max_mean_flow_px}) {
    vo::require(limit >= 0 && std::isfinite(limit), "filter: expected limits of 0 or above, got ",
                limit);
  }
}

void DatasetOptions::validate() const {
  constexpr int kMaxSeeds = 100'000;
  constexpr int kMaxPartFrames = 4000;  // of a folder that any file system lists quickly
  vo::require(is_name(name), "name: expected letters, digits and -, got '", name, "'");
  vo::require(seeds >= 1 && seeds <= kMaxSeeds, "seeds: expected 1 to ", kMaxSeeds, ", got ",
              seeds);
  vo::require(part_frames >= 1 && part_frames <= kMaxPartFrames, "part_frames: expected 1 to ",
              kMaxPartFrames, ", got ", part_frames);
  vo::require(!tar || formats.empty(), "tar: expected no formats with it, which are made of files");
}

std::vector<synth::TruthChannel> DatasetSpec::channels() const {
  std::string list;
  for (const std::string& name : names_in(options.channels)) {
    list += (list.empty() ? "" : ",") + name;
  }
  return list.empty() ? std::vector<synth::TruthChannel>() : synth::parse_channels(list);
}

std::vector<vo::WrittenSequence> DatasetSpec::formats() const {
  std::vector<vo::WrittenSequence> formats;
  for (const std::string& name : names_in(options.formats)) {
    formats.push_back(vo::parse_enum<vo::WrittenSequence>(name));
    vo::require(formats.back() != vo::WrittenSequence::tum,
                "formats: tum is always written, expected others");
  }
  return formats;
}

fs::path DatasetSpec::rig_file() const {
  return (fs::absolute(file).parent_path() / options.rig).lexically_normal();
}

DatasetSpec load_dataset_spec(const fs::path& file) {
  DatasetSpec spec;
  spec.file = file;
  spec.values = vo::read_toml(file);
  read_options(spec);
  read_spec_rig(spec);
  add_all_sequences(read_alternatives({file, spec.values, vo::toml_tables(file)}), spec);
  require_classes(spec);
  require_scenes(spec);
  require_usable_rig(spec);
  return spec;
}

}  // namespace tools
