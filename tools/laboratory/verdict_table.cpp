#include "tools/laboratory/verdict_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "tools/plot/table.h"
#include "tools/report/report.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::string_view kChanged = "CHANGED";
constexpr std::string_view kAlarm = "ALARM";

struct ShownMetric {
  const char* metric;
  const char* title;
  double factor;  ///< conversion factor to the title's unit
  int decimals;
};

constexpr std::array<ShownMetric, 5> kShown{{{"ate_rmse_m", "ate_mm", 1000, 2},
                                             {"rpe_translation_rmse_m", "rpe_mm", 1000, 2},
                                             {"rpe_rotation_rmse_deg", "rpe_deg", 1, 3},
                                             {"drift_percent", "drift_%", 1, 2},
                                             {"tracked_fraction", "tracked_%", 100, 1}}};

/// Returns a text such as `3.78`, or `3.78 +-0.21` with half the confidence interval.
std::string estimate_text(const Estimate& estimate, const ShownMetric& shown) {
  std::string text = format_decimals(shown.factor * estimate.mean, shown.decimals);
  if (estimate.high > estimate.low) {
    text += " +-" + format_decimals(shown.factor * (estimate.high - estimate.mean), shown.decimals);
  }
  return text;
}

bool was_kept(const ScenarioResult& scenario) {
  return !scenario.trials.empty() &&
         std::all_of(scenario.trials.begin(), scenario.trials.end(),
                     [](const TrialResult& trial) { return trial.was_kept; });
}

bool has_alarm(const std::string& scenario, const std::vector<Change>& changes) {
  return std::any_of(changes.begin(), changes.end(), [&](const Change& change) {
    return change.is_alarm() && change.scenario == scenario;
  });
}

/// Returns the tone of a verdict in the table of a test.
std::optional<Tone> tone_of_verdict(std::string_view verdict) {
  return verdict == to_text(Verdict::passed) ? Tone::good : Tone::bad;
}

/// Returns the tone of a verdict on a change: none unless it is an alarm, which one to the better
/// is too as long as nobody explained it.
std::optional<Tone> tone_of_change(std::string_view verdict) {
  if (verdict.starts_with(kAlarm)) {
    return verdict.ends_with(to_text(ChangeKind::better)) ? Tone::caution : Tone::bad;
  }
  return {};
}

Table table_of(const TestResults& results, const std::vector<Change>& changes) {
  Table table{.columns = {{"scenario"}, {"verdict", 0, tone_of_verdict}, {"frames"}}};
  for (const ShownMetric& shown : kShown) {
    table.columns.push_back({shown.title});
  }
  table.columns.push_back({"time_s"});
  for (const ScenarioResult& scenario : results.scenarios) {
    const bool changed = scenario.verdict() == Verdict::passed && has_alarm(scenario.name, changes);
    const double frames =
        scenario.trials.empty() ? 0 : static_cast<double>(scenario.trials.front().frames);
    std::vector<TableCell> row{
        scenario.name, changed ? std::string(kChanged) : to_text(scenario.verdict()), frames};
    for (const ShownMetric& shown : kShown) {
      row.emplace_back(estimate_text(estimate_mean(values_of(scenario, shown.metric)), shown));
    }
    row.emplace_back(was_kept(scenario) ? "kept" : format_decimals(scenario.time(), 1));
    table.add_row(std::move(row));
  }
  return table;
}

std::string sentences_of(const ScenarioResult& scenario) {
  std::string text;
  for (const std::string& complaint : complaints(scenario)) {
    text += scenario.name + ": " + complaint + "\n";
  }
  if (!text.empty() && !scenario.why.empty()) {
    text += "  it holds: " + scenario.why + "\n";
  }
  for (const TrialResult& trial : scenario.trials) {
    text += trial.note.empty() ? "" : scenario.name + ": " + trial.note + "\n";
  }
  return text;
}

std::string count_text(const TestResults& results, Verdict verdict, const char* name) {
  const auto count = std::count_if(results.scenarios.begin(), results.scenarios.end(),
                                   [&](const ScenarioResult& s) { return s.verdict() == verdict; });
  return count == 0 ? "" : vo::concat(", ", count, " ", name);
}

std::string verdict_of(const Change& change) {
  if (change.is_alarm()) {
    return std::string(kAlarm) + ": ";
  }
  if (change.is_significant) {
    return "small: ";
  }
  return change.has_too_few_seeds ? "too few seeds to tell: " : "chance: ";
}

}  // namespace

std::string format_verdicts(const TestResults& results, const std::vector<Change>& changes,
                            const Colours& colours) {
  std::string text = as_text(table_of(results, changes), colours);
  for (const ScenarioResult& scenario : results.scenarios) {
    text += sentences_of(scenario);
  }
  const auto alarms = std::count_if(changes.begin(), changes.end(),
                                    [](const Change& change) { return change.is_alarm(); });
  for (const Change& change : changes) {
    text += change.is_alarm() ? describe(change) + "\n" : "";
  }
  const bool passed = results.passed() && alarms == 0;
  const char* good = results.bounds == BoundsSource::scenario ? "within their bounds" : "measured";
  return text +
         vo::concat(passed ? colours.paint(Tone::good, "PASS") : colours.paint(Tone::bad, "FAIL"),
                    "  ", results.scenarios.size(), " scenarios",
                    count_text(results, Verdict::passed, good),
                    count_text(results, Verdict::failed, "FAILED"),
                    count_text(results, Verdict::error, "not measured"),
                    alarms > 0 ? vo::concat(", ", alarms, " changes of the baseline") : "", "\n");
}

std::string format_changes(const std::vector<Change>& changes, const Colours& colours) {
  Table table{.columns = {{"scenario"},
                          {"metric"},
                          {"before"},
                          {"after"},
                          {"change_%"},
                          {"p"},
                          {"verdict", 0, tone_of_change}}};
  std::size_t same = 0;
  for (const Change& change : changes) {
    if (!change.is_alarm() && !change.is_large && !change.is_significant) {
      ++same;
      continue;
    }
    table.add_row({change.scenario, change.metric, shown_number(change.before),
                   shown_number(change.after), format_decimals(change.percent, 1),
                   shown_number(change.p_value), verdict_of(change) + to_text(change.kind)});
  }
  std::stable_sort(table.rows.begin(), table.rows.end(), [](const auto& a, const auto& b) {
    const auto is_alarm = [](const std::vector<TableCell>& row) {
      return std::get<std::string>(row.back()).starts_with(kAlarm);
    };
    return is_alarm(a) && !is_alarm(b);
  });
  return (table.rows.empty() ? "" : as_text(table, colours)) +
         vo::concat(same, " of ", changes.size(), " metrics are the same within chance\n");
}

}  // namespace tools
