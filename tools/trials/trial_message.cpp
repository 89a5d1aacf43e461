#include "tools/trials/trial_message.h"

#include <csignal>
#include <limits>
#include <memory>

#include <nlohmann/json.hpp>

#include "tools/laboratory/results_json.h"
#include "tools/report/report_data.h"
#include "vo/core/error.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the trial of a process that was ended before it could tell.
TrialResult trial_without_result(const JobEnd& end, int seed) {
  TrialResult trial{.seed = seed};
  trial.metrics =
      make_metrics([](const std::string&) { return std::numeric_limits<double>::quiet_NaN(); });
  trial.kind = ProblemKind::crash;
  if (end.signal == 0) {
    trial.problem = "edvo's process for it was told to end";
    trial.kind = ProblemKind::temporary;
  } else if (end.signal == SIGKILL) {
    trial.problem = "edvo's process for it was killed, perhaps for want of memory";
  } else {
    trial.problem = vo::concat("edvo crashed on it (signal ", end.signal, ")");
  }
  return trial;
}

}  // namespace

Json json_of_trial(const TrialResult& trial) {
  Json json = {{"trial", trial_json(trial)},
               {"note", trial.note},
               {"was_kept", trial.was_kept},
               {"time", trial.time}};
  if (trial.report) {
    json["report"] = report_data({*trial.report})["scenarios"][0];
  }
  return json;
}

TrialResult trial_of_json(const Json& json) {
  TrialResult trial = trial_from_json(json.at("trial"));
  trial.note = json.at("note").get<std::string>();
  trial.was_kept = json.at("was_kept").get<bool>();
  trial.time = json.at("time").get<double>();
  if (json.contains("report")) {
    trial.report = std::make_shared<ScenarioReport>(report_of_data(json["report"]));
  }
  return trial;
}

std::string trial_message(const TrialResult& trial) {
  return json_of_trial(trial).dump(-1, ' ', false, Json::error_handler_t::replace);
}

TrialResult trial_of_process(const JobEnd& end, int seed) {
  return end.is_complete() ? trial_of_json(Json::parse(end.result))
                           : trial_without_result(end, seed);
}

}  // namespace tools
