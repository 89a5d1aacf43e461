#include "tools/studies/sweep.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "tools/plot/plot.h"
#include "tools/plot/statistics.h"
#include "tools/scenario/error_titles.h"
#include "vo/core/error.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

struct SweptMetric {
  const char* metric;
  const char* title;
  double factor;  ///< conversion factor to the title's unit
  int decimals;
};

constexpr std::array<SweptMetric, 4> kSweptMetrics{
    {{"ate_rmse_m", "ate_mm", 1000, 3},
     {"rpe_translation_rmse_m", "rpe_mm", 1000, 3},
     {"rpe_rotation_rmse_deg", "rpe_deg", 1, 4},
     {"tracked_fraction", "tracked_percent", 100, 1}}};

/// Metrics of modes mono and mapping.
constexpr std::array<SweptMetric, 7> kMapMetrics{
    {{"ate_percent", "ate_percent", 1, 3},
     {"scale_error_percent", "scale_percent", 1, 3},
     {"scale_drift_percent", "drift_percent_per_10m", 1, 2},
     {"depth_error_percent", "depth_percent", 1, 3},
     {"depth_outliers_percent", "outliers_percent", 1, 2},
     {"depth_nees", "nees", 1, 2},
     {"depth_density_fraction", "density_percent", 100, 1}}};

/// One row: a scenario with one combination of option values.
struct Combination {
  Assignments values;
  ScoreOptions score;  ///< how the scenario's errors are taken
  ScenarioResult result;

  Estimate estimate(const SweptMetric& swept) const {
    const Estimate plain = estimate_mean(values_of(result, swept.metric));
    return {swept.factor * plain.mean, swept.factor * plain.low, swept.factor * plain.high};
  }
};

/// Returns the finite values over the seeds, in the title's unit.
std::vector<double> measured_values(const Combination& row, const SweptMetric& swept) {
  std::vector<double> values;
  for (const double value : values_of(row.result, swept.metric)) {
    if (std::isfinite(value)) {
      values.push_back(swept.factor * value);
    }
  }
  return values;
}

/// Returns the metrics to show: those of maps only if one was measured.
std::vector<SweptMetric> shown_metrics(const std::vector<Combination>& rows) {
  std::vector<SweptMetric> shown(kSweptMetrics.begin(), kSweptMetrics.end());
  std::copy_if(kMapMetrics.begin(), kMapMetrics.end(), std::back_inserter(shown),
               [&](const SweptMetric& swept) {
                 return std::any_of(rows.begin(), rows.end(), [&](const Combination& row) {
                   return !measured_values(row, swept).empty();
                 });
               });
  return shown;
}

/// Throws Error where the combinations of so many scenarios are more than a table can be read of.
void require_countable(const std::vector<SweptOption>& options, std::size_t scenarios) {
  constexpr double kMaxRows = 100'000;
  auto rows = static_cast<double>(scenarios);
  for (const auto& [key, values] : options) {
    rows *= static_cast<double>(values.size());
  }
  if (rows > kMaxRows) {
    vo::fail_as(vo::ErrorKind::usage, "--set: the values have ", rows,
                " combinations over all scenarios, expected at most ", kMaxRows);
  }
}

/// Returns all combinations; the last option's values change fastest.
std::vector<Assignments> combine(const std::vector<SweptOption>& options) {
  std::vector<Assignments> combinations(1);
  for (const auto& [key, values] : options) {
    std::vector<Assignments> longer;
    for (const Assignments& combination : combinations) {
      for (const std::string& value : values) {
        longer.push_back(combination);
        longer.back().emplace_back(key, value);
      }
    }
    combinations = std::move(longer);
  }
  return combinations;
}

std::vector<Combination> rows_of(const std::vector<LoadedScenario>& scenarios,
                                 const std::vector<TrialResult>& trials,
                                 const SweepSettings& settings) {
  const std::vector<Assignments> combinations = combine(settings.options);
  std::vector<Combination> rows;
  auto next = trials.begin();
  for (const LoadedScenario& loaded : scenarios) {
    const Assignments& values = combinations[rows.size() % combinations.size()];
    rows.push_back({values, loaded.scenario->score, loaded.result});
    rows.back().result.trials.assign(next, next + settings.run.seeds);
    next += settings.run.seeds;
  }
  return rows;
}

std::string last_part(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

/// Returns the value with commas replaced by blanks, which do not split a CSV cell.
std::string without_commas(std::string value) {
  std::replace(value.begin(), value.end(), ',', ' ');
  return value;
}

Table make_table(const std::vector<Combination>& rows, const SweepSettings& settings) {
  const std::vector<SweptMetric> metrics = shown_metrics(rows);
  Table table{.columns = {{"scenario"}}};
  for (const auto& [key, values] : settings.options) {
    table.columns.push_back({last_part(key)});
  }
  for (const SweptMetric& swept : metrics) {
    table.columns.push_back({swept.title, swept.decimals});
    if (settings.run.seeds > 1) {
      table.columns.push_back({std::string(swept.title) + "_ci95", swept.decimals});
    }
  }
  for (const Combination& row : rows) {
    std::vector<TableCell> cells{row.result.name};
    for (const auto& [key, value] : row.values) {
      cells.emplace_back(without_commas(value));
    }
    for (const SweptMetric& swept : metrics) {
      const Estimate estimate = row.estimate(swept);
      cells.emplace_back(estimate.mean);
      if (settings.run.seeds > 1) {
        cells.emplace_back(estimate.high - estimate.mean);
      }
    }
    table.add_row(std::move(cells));
  }
  return table;
}

/// Returns the values as numbers; empty where one of them is not a number.
std::vector<double> as_numbers(const std::vector<std::string>& texts) {
  std::vector<double> numbers;
  for (const std::string& text : texts) {
    double number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) {
      return {};
    }
    numbers.push_back(number);
  }
  return numbers;
}

/// Returns a series name: the scenario and the values of all options but the first.
std::string series_name(const Combination& row) {
  std::string name = row.result.name;
  for (std::size_t i = 1; i < row.values.size(); ++i) {
    name += " " + last_part(row.values[i].first) + "=" + row.values[i].second;
  }
  return name;
}

/// Plots a metric over the first option, with a line per scenario and combination of the others.
PlotPanel draw_panel(const std::vector<Combination>& rows, const SweptOption& option,
                     const SweptMetric& swept, const std::string& title) {
  const std::vector<double> numbers = as_numbers(option.second);
  PlotPanel panel{.x = {.title = last_part(option.first)}, .y = {.title = title}};
  if (numbers.empty()) {
    panel.x.categories = option.second;
  }
  for (const Combination& row : rows) {
    const auto place = static_cast<std::size_t>(
        std::find(option.second.begin(), option.second.end(), row.values[0].second) -
        option.second.begin());
    const std::string name = series_name(row);
    auto series = std::find_if(panel.series.begin(), panel.series.end(),
                               [&](const PlotSeries& s) { return s.name == name; });
    if (series == panel.series.end()) {
      const int style = static_cast<int>(panel.series.size());
      series = panel.series.insert(
          series, {.name = name, .style = style, .mark = PlotMark::line_and_points, .points = {}});
    }
    const Estimate estimate = row.estimate(swept);
    series->points.push_back({numbers.empty() ? static_cast<double>(place) : numbers[place],
                              estimate.mean, estimate.high - estimate.mean});
  }
  return panel;
}

/// Returns the titles of the first three metrics, which are plotted.
std::array<std::string, 3> plot_titles(const std::vector<Combination>& rows) {
  const ScoreOptions& first = rows.front().score;
  const bool is_same = std::all_of(rows.begin(), rows.end(), [&](const Combination& row) {
    return row.score.align == first.align && row.score.interval == first.interval;
  });
  if (!is_same) {
    return {"ATE, mm, aligned as each scenario says", "RPE, mm, over each scenario's interval",
            "RPE, deg, over each scenario's interval"};
  }
  return {ate_title("mm", first.align), rpe_title("mm", first.interval),
          rpe_title("deg", first.interval)};
}

std::vector<std::string> problems_of(const std::vector<Combination>& rows) {
  std::vector<std::string> sentences;
  for (const Combination& row : rows) {
    for (const std::string& complaint : complaints(row.result)) {
      std::string name = row.result.name;
      for (const auto& [key, value] : row.values) {
        name += vo::concat(" ", last_part(key), "=", value);
      }
      sentences.push_back(vo::concat(name, ": ", complaint));
    }
  }
  return sentences;
}

/// Returns the metric's values with one combination of the options, over all scenarios and seeds.
std::vector<double> values_over_all(const std::vector<Combination>& rows, const Assignments& values,
                                    const SweptMetric& swept) {
  std::vector<double> trials;
  for (const Combination& row : rows) {
    if (row.values == values) {
      const std::vector<double> more = measured_values(row, swept);
      trials.insert(trials.end(), more.begin(), more.end());
    }
  }
  return trials;
}

/// Returns a sentence per combination with medians over all scenarios and seeds.
std::vector<std::string> medians_of(const std::vector<Combination>& rows,
                                    const SweepSettings& settings) {
  std::vector<std::string> sentences;
  for (const Assignments& values : combine(settings.options)) {
    std::string sentence = "Medians";
    for (const auto& [key, value] : values) {
      sentence += vo::concat(" ", last_part(key), "=", value);
    }
    for (const SweptMetric& swept : shown_metrics(rows)) {
      const std::vector<double> trials = values_over_all(rows, values, swept);
      if (!trials.empty()) {
        sentence +=
            vo::concat("; ", swept.title, " ", format_decimals(median(trials), swept.decimals));
      }
    }
    sentences.push_back(sentence + ".");
  }
  return sentences;
}

void require_no_temporary_problem(const std::vector<Combination>& rows) {
  for (const Combination& row : rows) {
    for (const TrialResult& trial : row.result.trials) {
      if (!trial.problem.empty() && trial.kind == ProblemKind::temporary) {
        vo::fail_as(vo::ErrorKind::temporary, row.result.name, ": ", trial.problem,
                    "; what was measured is kept, the same command continues there");
      }
    }
  }
}

}  // namespace

std::vector<LoadedScenario> swept_scenarios(const std::vector<fs::path>& files,
                                            const std::vector<SweptOption>& options) {
  require_countable(options, files.size());
  const std::vector<Assignments> combinations = combine(options);
  std::vector<LoadedScenario> scenarios;
  for (const fs::path& file : files) {
    for (const Assignments& values : combinations) {
      Scenario scenario = load_scenario(file, values);
      scenario.require_scene();
      scenarios.push_back(
          {.result = {.name = scenario.name, .why = scenario.why}, .scenario = scenario});
    }
  }
  return scenarios;
}

StudyReport sweep_report(const std::vector<LoadedScenario>& scenarios,
                         const std::vector<TrialResult>& trials, const SweepSettings& settings) {
  const std::vector<Combination> rows = rows_of(scenarios, trials, settings);
  require_no_temporary_problem(rows);
  std::string title = "Sweep:";
  for (const auto& [key, values] : settings.options) {
    title += " " + key;
  }
  std::vector<PlotPanel> panels;
  for (const std::string& axis : plot_titles(rows)) {
    panels.push_back(
        draw_panel(rows, settings.options.front(), kSweptMetrics.at(panels.size()), axis));
  }
  std::vector<std::string> findings = problems_of(rows);
  if (trials.size() > combine(settings.options).size()) {
    const std::vector<std::string> medians = medians_of(rows, settings);
    findings.insert(findings.end(), medians.begin(), medians.end());
  }
  return {.name = "sweep",
          .title = title,
          .method = vo::concat("Every combination of the options' values, ", settings.run.seeds,
                               settings.run.seeds == 1 ? " seed" : " seeds",
                               " each; ci95 is half the 95 % confidence interval of the mean."),
          .table = make_table(rows, settings),
          .findings = std::move(findings),
          .plot = draw_plot(title, panels),
          .more = {}};
}

}  // namespace tools
