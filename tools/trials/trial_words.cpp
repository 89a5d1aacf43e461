#include "tools/trials/trial_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tools/scenario/run_scenario.h"
#include "vo/core/error.h"

namespace tools {

std::string trial_name(const TrialJob& job) {
  return job.scenario.name + (job.seed == 0 ? "" : vo::concat(", seed ", job.seed));
}

std::string trial_word(const TrialJob& job, const TrialResult& trial, const RunSettings& settings) {
  if (!trial.problem.empty()) {
    return "error";
  }
  if (settings.bounds != BoundsSource::scenario) {
    return "measured";
  }
  const std::vector<BoundCheck> checks = check_bounds(trial.metrics, job.scenario.expect);
  const bool holds = std::all_of(checks.begin(), checks.end(), [&](const BoundCheck& check) {
    return check.holds || (settings.trial.tracker && std::isnan(check.measured));
  });
  return holds ? "passed" : "failed";
}

std::string trial_figures(const TrialResult& trial) {
  constexpr double kPercent = 100;
  constexpr double kMicrometers = 1e6;
  if (!trial.problem.empty()) {
    return trial.problem;
  }
  return vo::concat("ATE ", std::round(kMicrometers * trial.metrics.ate_rmse_m) / 1000, " mm, ",
                    std::round(kPercent * trial.metrics.tracked_fraction), " % tracked");
}

std::string passed_scenarios(const TestResults& results) {
  const auto passed =
      std::count_if(results.scenarios.begin(), results.scenarios.end(),
                    [](const ScenarioResult& s) { return s.verdict() == Verdict::passed; });
  return vo::concat(passed, " of ", results.scenarios.size(), " scenarios passed");
}

}  // namespace tools
