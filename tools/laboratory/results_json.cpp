#include "tools/laboratory/results_json.h"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/input.h"
#include "vo/text_files/json_limits.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr JsonSchema kSchema{"results"};

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double number_at(const Json& json, const std::string& key,
                 double otherwise = std::numeric_limits<double>::quiet_NaN()) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : otherwise;
}

Json scenario_json(const ScenarioResult& scenario) {
  Json json = {{"name", scenario.name},
               {"why", scenario.why},
               {"verdict", to_text(scenario.verdict())},
               {"complaints", complaints(scenario)}};
  for (const auto& [metric, estimate] : estimate_metrics(scenario)) {
    json["metrics"][metric] = {{"mean", number_or_null(estimate.mean)},
                               {"low", number_or_null(estimate.low)},
                               {"high", number_or_null(estimate.high)}};
  }
  json["bounds"] = Json::object();
  for (const BoundCheck& check : scenario.checks) {
    json["bounds"][check.metric] = {{"measured", number_or_null(check.measured)},
                                    {"min", number_or_null(check.bound.min)},
                                    {"max", number_or_null(check.bound.max)},
                                    {"holds", check.holds}};
  }
  json["trials"] = Json::array();
  for (const TrialResult& trial : scenario.trials) {
    json["trials"].push_back(trial_json(trial));
  }
  return json;
}

std::vector<BoundCheck> checks_from_json(const Json& bounds) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<BoundCheck> checks;
  for (const auto& [metric, bound] : bounds.items()) {
    checks.push_back(
        {.metric = metric,
         .measured = number_at(bound, "measured"),
         .bound = {number_at(bound, "min", -kInfinity), number_at(bound, "max", kInfinity)},
         .holds = bound.at("holds").get<bool>()});
  }
  return checks;
}

/// Returns a whole number of at least 0 that an int holds. Throws vo::Error beginning with its key.
int count_at(const Json& json, const std::string& key) {
  constexpr int kMost = std::numeric_limits<int>::max();
  const Json& value = json.at(key);
  const bool is_count = value.is_number() && value.get<double>() >= 0 &&
                        value.get<double>() <= kMost &&
                        std::trunc(value.get<double>()) == value.get<double>();
  vo::require(is_count, key, ": expected a whole number from 0 to ", kMost, ", got ",
              value.is_number() ? value.dump() : value.type_name());
  return static_cast<int>(value.get<double>());
}

std::vector<TrialResult> trials_from_json(const Json& json) {
  std::vector<TrialResult> trials;
  std::set<int> seeds;
  for (const Json& trial : json) {
    trials.push_back(trial_from_json(trial));
    const int seed = trials.back().seed;
    vo::require(seeds.insert(seed).second, "seed: ", seed,
                " is there twice, expected trials of different seeds");
  }
  return trials;
}

/// Returns a scenario's result. Throws vo::Error, naming the scenario, for a trial that cannot be.
ScenarioResult scenario_from_json(const Json& json) {
  ScenarioResult scenario{.name = json.at("name").get<std::string>(),
                          .why = json.value("why", std::string())};
  try {
    scenario.trials = trials_from_json(json.at("trials"));
  } catch (const vo::Error& error) {
    vo::fail(scenario.name, ": ", error.what());
  }
  scenario.checks = checks_from_json(json.value("bounds", Json::object()));
  return scenario;
}

/// Returns the results of a list. Throws vo::Error, naming the file, for one that cannot be, and
/// for two of one name.
std::vector<ScenarioResult> scenarios_from_json(const Json& json, const std::string& file) {
  std::vector<ScenarioResult> scenarios;
  std::set<std::string> names;
  try {
    for (const Json& scenario : json) {
      scenarios.push_back(scenario_from_json(scenario));
      vo::require(names.insert(scenarios.back().name).second, scenarios.back().name,
                  ": is there twice, expected scenarios of different names");
    }
  } catch (const vo::Error& error) {
    vo::fail(file, ": ", error.what());
  }
  return scenarios;
}

/// Returns the metrics that no trial of a file names, not even as unmeasured.
std::set<std::string> unknown_metrics(const Json& scenarios) {
  std::set<std::string> unknown;
  for (const auto& [metric, unused] : metric_values({})) {
    unknown.insert(metric);
  }
  for (const Json& scenario : scenarios) {
    for (const Json& trial : scenario.at("trials")) {
      for (const auto& [metric, value] : trial.at("metrics").items()) {
        unknown.erase(metric);
      }
    }
  }
  return unknown;
}

}  // namespace

Json trial_json(const TrialResult& trial) {
  Json json = {{"seed", trial.seed}, {"sequence", trial.sequence}, {"frames", trial.frames}};
  for (const auto& [metric, value] : metric_values(trial.metrics)) {
    json["metrics"][metric] = number_or_null(value);
  }
  if (!trial.problem.empty()) {
    json["problem"] = trial.problem;
    json["problem_kind"] = vo::to_string(trial.kind);
  }
  return json;
}

TrialResult trial_from_json(const Json& json) {
  TrialResult trial{.seed = count_at(json, "seed"),
                    .sequence = json.at("sequence").get<std::string>(),
                    .frames = static_cast<std::size_t>(count_at(json, "frames"))};
  const Json& metrics = json.at("metrics");
  trial.metrics = make_metrics([&](const std::string& name) { return number_at(metrics, name); });
  trial.problem = json.value("problem", std::string());
  const std::string kind = json.value("problem_kind", std::string());
  trial.kind = kind.empty() ? ProblemKind::unusable : vo::parse_enum<ProblemKind>(kind);
  return trial;
}

Json results_json(const TestResults& results) {
  Json json = json_document(kSchema, {{"edvo", results.edvo},
                                      {"tracker", results.tracker},
                                      {"passed", results.passed()},
                                      {"scenarios", Json::array()}});
  for (const ScenarioResult& scenario : results.scenarios) {
    json["scenarios"].push_back(scenario_json(scenario));
  }
  return json;
}

TestResults read_results(const std::filesystem::path& file) {
  const std::string text = vo::read_file(file, vo::kMaxDocumentBytes);
  vo::require_json_within_limits(text, file.string());
  try {
    const Json json = Json::parse(text);
    vo::require(json.value("schema", std::string()) == vo::concat("edvo.", kSchema.name),
                file.string(), ": expected the results of `edvo test --json`");
    const Json& found = json.at("schema_version");
    vo::require(found == kSchema.version, file.string(), ": has schema version ", found.dump(),
                ", expected ", kSchema.version);
    TestResults results{.edvo = json.value("edvo", std::string()),
                        .tracker = json.value("tracker", std::string()),
                        .scenarios = scenarios_from_json(json.at("scenarios"), file.string())};
    results.unknown_metrics = unknown_metrics(json.at("scenarios"));
    return results;
  } catch (const nlohmann::json::exception& error) {
    vo::fail(file.string(), ": expected the results of `edvo test --json`: ", error.what());
  }
}

}  // namespace tools
