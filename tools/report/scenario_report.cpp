#include "tools/report/scenario_report.h"

#include <algorithm>

#include "vo/core/fields.h"

namespace tools {
namespace {

std::vector<ReportedMetric> reported_metrics(const Outcome& outcome) {
  std::vector<ReportedMetric> metrics;
  for (const auto& [name, value] : metric_values(outcome.metrics)) {
    ReportedMetric& metric = metrics.emplace_back();
    metric.name = name;
    metric.value = value;
    const auto check = std::find_if(outcome.checks.begin(), outcome.checks.end(),
                                    [&](const BoundCheck& c) { return c.metric == metric.name; });
    if (check != outcome.checks.end()) {
      metric.bound = check->bound;
      metric.holds = check->holds;
    }
  }
  return metrics;
}

/// Returns the scenario's options with the values that they have without it.
std::vector<ReportedOption> reported_options(const Scenario& scenario) {
  Scenario actual = scenario;
  Scenario preset;
  preset.odometry = odometry_defaults(scenario.odometry.mode, scenario.odometry.preset);
  const std::vector<vo::Field> fields = vo::fields_of(actual);
  const std::vector<vo::Field> preset_fields = vo::fields_of(preset);
  std::vector<ReportedOption> options;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    options.push_back({fields[i].key, fields[i].get(), preset_fields[i].get(), fields[i].help});
  }
  return options;
}

}  // namespace

bool ScenarioReport::passed() const {
  return problem.empty() && std::all_of(metrics.begin(), metrics.end(),
                                        [](const ReportedMetric& m) { return m.holds; });
}

ScenarioReport scenario_report(const Scenario& scenario, const Outcome& outcome) {
  ScenarioReport report;
  report.name = scenario.name;
  report.why = scenario.why;
  report.repeat = repeat_run(scenario);
  report.metrics = reported_metrics(outcome);
  report.notes = outcome.notes;
  report.options = reported_options(scenario);
  report.camera = scenario.camera.camera().pinhole;
  report.alignment = scenario.score.align;
  report.truth = outcome.truth;
  report.estimate = outcome.tracking.trajectory;
  report.frames = outcome.tracking.frames;
  return report;
}

ScenarioReport outside_report(const Scenario& scenario, const Outcome& outcome,
                              const std::string& tracker) {
  ScenarioReport report = scenario_report(scenario, outcome);
  report.tracker = tracker;
  report.repeat = repeat_test(scenario, tracker);
  std::erase_if(report.options,
                [](const ReportedOption& option) { return option.key.starts_with("odometry."); });
  return report;
}

}  // namespace tools
