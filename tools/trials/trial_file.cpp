#include "tools/trials/trial_file.h"

#include <algorithm>
#include <cstdint>
#include <exception>

#include <nlohmann/json.hpp>

#include "synth/sequence/render_sequence.h"
#include "tools/processes/shell_words.h"
#include "tools/sequence_cache/scene_files_hash.h"
#include "tools/trials/trial_message.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/input.h"
#include "vo/files/result_files.h"
#include "vo/files/unlocked_file.h"
#include "vo/hashing/content_hash.h"
#include "vo/text_files/json_limits.h"
#include "vo/text_files/toml_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

constexpr const char* kTrialSchema = "edvo.trial";
constexpr int kTrialVersion = 1;

/// Returns the size and, unless it is very large, the hash of a file; empty where a word names
/// none.
std::string file_hash(const fs::path& word) {
  std::error_code ignored;
  if (!fs::is_regular_file(word, ignored)) {
    return "";
  }
  const std::uintmax_t size = fs::file_size(word, ignored);
  return vo::concat(size, " ",
                    size <= vo::kMaxDocumentBytes ? vo::content_hash(vo::read_file(word)) : "");
}

/// Returns the hash of an outside tracker: its command, its limits and the files that the command
/// names.
std::string tracker_hash(const OutsideTracker& tracker) {
  TrackerLimits limits = tracker.limits;
  std::string text = tracker.command + "\n" + vo::format_toml(vo::fields_of(limits)) + "\n";
  for (const std::string& word : split_words(tracker.command)) {
    text += file_hash(word) + "\n";
  }
  return vo::content_hash(text);
}

/// Returns the hash of a scenario's fields that a trial depends on, and of the files that they name
/// beside the scene.
std::string scenario_hash(const Scenario& scenario) {
  Scenario copy = scenario;
  std::vector<vo::Field> fields = vo::fields_of(copy);
  std::erase_if(fields,
                [](const vo::Field& field) { return field.key == "why" || field.key == "slow"; });
  const synth::PathOptions path = scenario.resolved_path();
  std::string text = vo::concat(vo::format_toml(fields), "\n", file_hash(path.file), "\n",
                                file_hash(path.file_times), "\n", forest_models_hash(scenario));
  text += synth::format_actors(scenario.actors);
  for (const synth::ActorOptions& actor : scenario.actors) {
    text += scene_files_hash(actor.file) + "\n";
  }
  text += scenario.expect.contains("repeat_difference_m") ? "twice" : "once";
  return vo::content_hash(text);
}

/// Returns the two lines of a file, without their line feeds.
std::pair<std::string, std::string> lines_of(const std::string& text) {
  const std::size_t end = text.find('\n');
  vo::require(end != std::string::npos && text.ends_with('\n') && end + 1 < text.size(),
              "it ends early");
  return {text.substr(0, end), text.substr(end + 1, text.size() - end - 2)};
}

void check_head(const Json& head, const std::string& body) {
  vo::require(head.value("schema", std::string()) == kTrialSchema, "it is no trial");
  const Json& version = head.at("schema_version");
  vo::require(version == kTrialVersion, "it has schema version ", version.dump(), ", expected ",
              kTrialVersion);
  vo::require(head.at("hash").get<std::string>() == vo::content_hash(body),
              "its bytes are not those that were written");
}

TrialFile parse_trial_file(const std::string& text, const std::string& place) {
  const auto [head, body] = lines_of(text);
  vo::require_json_within_limits(head, place);
  check_head(Json::parse(head), body);
  vo::require_json_within_limits(body, place);
  const Json json = Json::parse(body);
  TrialFile file;
  for (const auto& [name, hash] : json.at("key").items()) {
    file.key.emplace_back(name, hash.get<std::string>());
  }
  file.trial = trial_of_json(json.at("result"));
  return file;
}

}  // namespace

TrialKeys::TrialKeys(const TrialSettings& settings)
    : tracker_(settings.tracker ? tracker_hash(*settings.tracker) : "edvo") {
  if (settings.pictures) {
    pictures_ = vo::concat(settings.pictures->max_bytes, " bytes, ", settings.pictures->max_width,
                           " px wide");
  }
}

TrialKey TrialKeys::key(const Scenario& scenario, int seed) {
  return {{"program", program_hash()},
          {"tracker", tracker_},
          {"scenario", scenario_hash(with_seed(scenario, seed))},
          {"scene", scene_hash(scenario.scene_file())},
          {"pictures", seed == 0 ? pictures_ : ""}};
}

const std::string& TrialKeys::scene_hash(const fs::path& gltf) {
  const auto found = std::find_if(scenes_.begin(), scenes_.end(),
                                  [&](const auto& scene) { return scene.first == gltf; });
  return found != scenes_.end() ? found->second
                                : scenes_.emplace_back(gltf, scene_files_hash(gltf)).second;
}

std::string forest_models_hash(const Scenario& scenario) {
  Scenario copy = scenario;
  std::string text;
  for (const vo::Field& field : vo::fields_of(copy)) {
    text += field.key.ends_with(".forest_model") ? file_hash(field.get()) + "\n" : "";
  }
  return text;
}

void write_trial(const fs::path& path, const TrialFile& file, vo::Durability durability) {
  Json key = Json::object();
  for (const auto& [name, hash] : file.key) {
    key[name] = hash;
  }
  const std::string body = Json{{"key", key}, {"result", json_of_trial(file.trial)}}.dump(
      -1, ' ', false, Json::error_handler_t::replace);
  const Json head{{"schema", kTrialSchema},
                  {"schema_version", kTrialVersion},
                  {"hash", vo::content_hash(body)}};
  vo::make_folder(path.parent_path());
  vo::write_unlocked(path, head.dump() + "\n" + body + "\n", durability);
}

TrialFile read_trial(const fs::path& path) {
  const std::string text = vo::read_file(path, vo::kMaxDocumentBytes);
  try {
    return parse_trial_file(text, path.string());
  } catch (const nlohmann::json::exception&) {
    vo::fail(path.string(), ": it is no trial of `edvo test`");
  } catch (const vo::Error& error) {
    vo::fail(path.string(), ": ", error.what());
  }
}

std::string difference(const TrialKey& found, const TrialKey& expected) {
  for (const auto& part : expected) {
    if (std::find(found.begin(), found.end(), part) == found.end()) {
      return part.first;
    }
  }
  return "";
}

}  // namespace tools
