#include "tools/laboratory/results_json.h"

#include <cmath>
#include <limits>

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

ScenarioResult scenario_from_json(const Json& json) {
  ScenarioResult scenario{.name = json.at("name").get<std::string>(),
                          .why = json.value("why", std::string())};
  for (const Json& trial : json.at("trials")) {
    scenario.trials.push_back(trial_from_json(trial));
  }
  scenario.checks = checks_from_json(json.value("bounds", Json::object()));
  return scenario;
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
  TrialResult trial{.seed = json.at("seed").get<int>(),
                    .sequence = json.at("sequence").get<std::string>(),
                    .frames = json.at("frames").get<std::size_t>()};
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
    const int found = json.at("schema_version").get<int>();
    vo::require(found == kSchema.version, file.string(), ": has schema version ", found,
                ", expected ", kSchema.version);
    TestResults results{.edvo = json.value("edvo", std::string()),
                        .tracker = json.value("tracker", std::string()),
                        .scenarios = {}};
    for (const Json& scenario : json.at("scenarios")) {
      results.scenarios.push_back(scenario_from_json(scenario));
    }
    results.unknown_metrics = unknown_metrics(json.at("scenarios"));
    return results;
  } catch (const nlohmann::json::exception& error) {
    vo::fail(file.string(), ": expected the results of `edvo test --json`: ", error.what());
  }
}

}  // namespace tools
