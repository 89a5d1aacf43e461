#include "tools/laboratory/results.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/report/report.h"
#include "vo/core/error.h"

namespace tools {
namespace {

double value_of(const Metrics& metrics, const std::string& metric) {
  for (const auto& [name, value] : metric_values(metrics)) {
    if (name == metric) {
      return value;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::string to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "ok";
    case Verdict::failed:
      return "FAILED";
    case Verdict::error:
      break;
  }
  return "ERROR";
}

Verdict ScenarioResult::verdict() const {
  const bool has_problem =
      trials.empty() || std::any_of(trials.begin(), trials.end(),
                                    [](const TrialResult& t) { return !t.problem.empty(); });
  if (has_problem) {
    return Verdict::error;
  }
  const bool holds = std::all_of(checks.begin(), checks.end(),
                                 [](const BoundCheck& check) { return check.holds; });
  return holds ? Verdict::passed : Verdict::failed;
}

double ScenarioResult::time() const {
  double sum = 0;
  for (const TrialResult& trial : trials) {
    sum += trial.time;
  }
  return sum;
}

bool TestResults::passed() const {
  return std::all_of(scenarios.begin(), scenarios.end(),
                     [](const ScenarioResult& s) { return s.verdict() == Verdict::passed; });
}

std::vector<double> values_of(const ScenarioResult& scenario, const std::string& metric) {
  std::vector<double> values;
  for (const TrialResult& trial : scenario.trials) {
    if (trial.problem.empty()) {
      values.push_back(value_of(trial.metrics, metric));
    }
  }
  return values;
}

std::vector<std::pair<std::string, Estimate>> estimate_metrics(const ScenarioResult& scenario) {
  std::vector<std::pair<std::string, Estimate>> estimates;
  for (const auto& [metric, unused] : metric_values({})) {
    estimates.emplace_back(metric, estimate_mean(values_of(scenario, metric)));
  }
  return estimates;
}

std::vector<BoundCheck> check_means(const ScenarioResult& scenario,
                                    const std::map<std::string, Bound>& expect) {
  const auto mean = [&](const std::string& metric) {
    return estimate_mean(values_of(scenario, metric)).mean;
  };
  return check_bounds(make_metrics(mean), expect);
}

std::string violation_text(const BoundCheck& check) {
  return check.metric + " is " + shown_number(check.measured) + ", expected " +
         bound_text(check.bound);
}

std::vector<std::string> complaints(const ScenarioResult& scenario) {
  std::vector<std::string> sentences;
  for (const TrialResult& trial : scenario.trials) {
    if (!trial.problem.empty()) {
      sentences.push_back(scenario.trials.size() > 1
                              ? vo::concat("seed ", trial.seed, ": ", trial.problem)
                              : trial.problem);
    }
  }
  for (const BoundCheck& check : scenario.checks) {
    if (!check.holds) {
      sentences.push_back(violation_text(check));
    }
  }
  return sentences;
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    text += (text.empty() ? "" : "; ") + sentence;
  }
  return text;
}

}  // namespace tools
