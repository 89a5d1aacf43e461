#include "tools/laboratory/test_report.h"

#include <algorithm>
#include <string>

#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::size_t kPictureBytes = 6'000'000;  // bytes of pictures of all scenarios together

void judge_by_means(ScenarioReport& report, const ScenarioResult& result) {
  for (ReportedMetric& metric : report.metrics) {
    metric.value = estimate_mean(values_of(result, metric.name)).mean;
    metric.bound = {};
    metric.holds = true;
  }
  for (const BoundCheck& check : result.checks) {
    const auto metric =
        std::find_if(report.metrics.begin(), report.metrics.end(),
                     [&](const ReportedMetric& m) { return m.name == check.metric; });
    if (metric != report.metrics.end()) {
      metric->bound = check.bound;
      metric->holds = check.holds;
    }
  }
}

/// Returns what metrics and bounds do not show: the trials' problems and the alarms.
std::string problems_of(const ScenarioResult& result, const std::vector<Change>& changes) {
  std::vector<std::string> sentences;
  for (const TrialResult& trial : result.trials) {
    if (!trial.problem.empty()) {
      sentences.push_back(trial.problem);
    }
  }
  const std::vector<std::string> alarms = alarms_of(result.name, changes);
  sentences.insert(sentences.end(), alarms.begin(), alarms.end());
  return joined(sentences);
}

ScenarioReport report_of(const ScenarioResult& result, const std::vector<Change>& changes) {
  ScenarioReport report;
  if (!result.trials.empty() && result.trials.front().report) {
    report = *result.trials.front().report;
  }
  report.name = result.name;
  report.why = result.why;
  judge_by_means(report, result);
  report.problem = problems_of(result, changes);
  if (result.trials.size() > 1) {
    report.notes.push_back(vo::concat("metrics are means over ", result.trials.size(),
                                      " seeds, curves and pictures those of the first"));
  }
  return report;
}

}  // namespace

GalleryOptions pictures_of_each(std::size_t scenarios) {
  GalleryOptions options;
  options.max_bytes =
      std::min(options.max_bytes, kPictureBytes / std::max<std::size_t>(scenarios, 1));
  return options;
}

std::vector<ScenarioReport> test_reports(const TestResults& results,
                                         const std::vector<Change>& changes) {
  std::vector<ScenarioReport> reports;
  for (const ScenarioResult& result : results.scenarios) {
    reports.push_back(report_of(result, changes));
  }
  const std::string together = joined(alarms_of(kAllScenarios, changes));
  if (!together.empty()) {
    ScenarioReport& report = reports.emplace_back();
    report.name = kAllScenarios;
    report.problem = together;
  }
  return reports;
}

}  // namespace tools
