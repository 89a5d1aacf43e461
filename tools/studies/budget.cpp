#include "tools/studies/budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "tools/plot/plot.h"
#include "tools/scenario/error_titles.h"
#include "tools/statistics/significance.h"
#include "tools/studies/imperfections.h"
#include "tools/studies/shapley.h"
#include "vo/core/error.h"

namespace tools {
namespace {

struct BudgetMetric {
  double Metrics::*value;
  const char* name;
  double factor;  ///< conversion factor to the name's unit
};

constexpr std::array<BudgetMetric, 3> kBudgetMetrics{
    {{&Metrics::ate_rmse_m, "ate_mm", 1000},
     {&Metrics::rpe_translation_rmse_m, "rpe_mm", 1000},
     {&Metrics::rpe_rotation_rmse_deg, "rpe_deg", 1}}};

/// A player of the Shapley game: imperfections that are switched together.
using Group = std::vector<Imperfection>;

/// Cached metrics by set of groups switched on; bit i of a set is group i.
class Measurements {
 public:
  Measurements(const Scenario& scenario, const BudgetSettings& settings,
               const vo::Progress& progress, const vo::WaitObserver& waiting)
      : scenario_(scenario), settings_(settings), progress_(progress), waiting_(waiting) {}

  /// Measures the sets without cached metrics; cache keys depend on the groups' contents.
  void measure(const std::vector<Group>& groups, const std::vector<std::uint32_t>& sets) {
    std::vector<TrialJob> jobs;
    std::vector<std::string> keys;
    for (const std::uint32_t set : sets) {
      const std::string key = key_of(groups, set);
      if (known_.contains(key) || std::find(keys.begin(), keys.end(), key) != keys.end()) {
        continue;
      }
      keys.push_back(key);
      for (int seed = 0; seed < settings_.run.seeds; ++seed) {
        jobs.push_back({without(scenario_, off(groups, set)), seed});
      }
    }
    const std::vector<TrialResult> results = run_trials(jobs, settings_.run, progress_, waiting_);
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (!results[i].problem.empty()) {
        vo::fail_as(results[i].kind == ProblemKind::temporary ? vo::ErrorKind::temporary
                                                              : vo::ErrorKind::input,
                    scenario_.name, ": ", results[i].problem);
      }
      known_[keys[i / seeds()]].push_back(results[i].metrics);
    }
  }

  /// Returns the values by seed, in the unit of the metric's name.
  std::vector<double> values(const std::vector<Group>& groups, std::uint32_t set,
                             const BudgetMetric& metric) const {
    std::vector<double> values;
    for (const Metrics& metrics : known_.at(key_of(groups, set))) {
      values.push_back(metric.factor * metrics.*metric.value);
    }
    return values;
  }

 private:
  std::size_t seeds() const { return static_cast<std::size_t>(settings_.run.seeds); }

  static std::vector<Imperfection> off(const std::vector<Group>& groups, std::uint32_t set) {
    std::vector<Imperfection> result;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if ((set >> i & 1) == 0) {
        result.insert(result.end(), groups[i].begin(), groups[i].end());
      }
    }
    return result;
  }

  static std::string key_of(const std::vector<Group>& groups, std::uint32_t set) {
    std::vector<std::string> names;
    for (const Imperfection& imperfection : off(groups, set)) {
      names.push_back(imperfection.name);
    }
    std::sort(names.begin(), names.end());
    std::string key;
    for (const std::string& name : names) {
      key += name + " ";
    }
    return key;
  }

  const Scenario& scenario_;
  const BudgetSettings& settings_;
  const vo::Progress& progress_;
  const vo::WaitObserver& waiting_;
  std::map<std::string, std::vector<Metrics>> known_;  ///< by names switched off, then seed
};

std::uint32_t all_of(const std::vector<Group>& groups) {
  return (std::uint32_t{1} << groups.size()) - 1;
}

double mean_of(const std::vector<double>& values) {
  return estimate_mean(values).mean;
}

/// Returns the sets with none, with all, with each group alone and with all but each group.
std::vector<std::uint32_t> one_by_one(const std::vector<Group>& groups) {
  const std::uint32_t all = all_of(groups);
  std::vector<std::uint32_t> sets{0, all};
  for (std::size_t i = 0; i < groups.size(); ++i) {
    sets.push_back(std::uint32_t{1} << i);
    sets.push_back(all & ~(std::uint32_t{1} << i));
  }
  return sets;
}

/// Returns the groups ordered by decreasing effect on the ATE; those after `top` form one group.
std::vector<Group> top_groups(const std::vector<Group>& singles, const Measurements& measured,
                              int top) {
  const BudgetMetric& ate = kBudgetMetrics.front();
  const std::uint32_t all = all_of(singles);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const std::uint32_t bit = std::uint32_t{1} << i;
    const double effect = mean_of(measured.values(singles, all, ate)) -
                          mean_of(measured.values(singles, all & ~bit, ate)) +
                          mean_of(measured.values(singles, bit, ate)) -
                          mean_of(measured.values(singles, 0, ate));
    order.emplace_back(std::isfinite(effect) ? -std::abs(effect) : 0, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Group> groups;
  for (const auto& [effect, i] : order) {
    const bool is_own = groups.size() < static_cast<std::size_t>(top) ||
                        singles.size() <= static_cast<std::size_t>(top) + 1;
    if (is_own || groups.size() == static_cast<std::size_t>(top)) {
      groups.push_back(singles[i]);
    } else {
      groups.back().insert(groups.back().end(), singles[i].begin(), singles[i].end());
    }
  }
  return groups;
}

/// Returns the Shapley value of each group, estimated over the seeds.
std::vector<Estimate> shares_of(const std::vector<Group>& groups, const Measurements& measured,
                                const BudgetMetric& metric, int seeds) {
  std::vector<std::vector<double>> by_group(groups.size());
  for (int seed = 0; seed < seeds; ++seed) {
    const std::vector<double> shares =
        shapley_values(static_cast<int>(groups.size()), [&](std::uint32_t set) {
          return measured.values(groups, set, metric)[static_cast<std::size_t>(seed)];
        });
    for (std::size_t i = 0; i < groups.size(); ++i) {
      by_group[i].push_back(shares[i]);
    }
  }
  std::vector<Estimate> estimates;
  for (const std::vector<double>& shares : by_group) {
    estimates.push_back(estimate_mean(shares));
  }
  return estimates;
}

std::string name_of(const Group& group) {
  std::string name;
  for (const Imperfection& imperfection : group) {
    name += (name.empty() ? "" : "+") + imperfection.name;
  }
  return name;
}

double half_width(const Estimate& estimate) {
  return estimate.high - estimate.mean;
}

/// Adds the rows of one metric to the budget table.
void add_rows(Table& table, const std::vector<Group>& groups, const Measurements& measured,
              const BudgetMetric& metric, int seeds) {
  const std::uint32_t all = all_of(groups);
  const double whole = mean_of(measured.values(groups, all, metric));
  const Estimate floor = estimate_mean(measured.values(groups, 0, metric));
  const std::vector<Estimate> shares = shares_of(groups, measured, metric, seeds);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  table.add_row({metric.name, "perfect camera", floor.mean, kNone, floor.mean, half_width(floor),
                 100 * floor.mean / whole});
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::uint32_t bit = std::uint32_t{1} << i;
    table.add_row({metric.name, name_of(groups[i]), mean_of(measured.values(groups, bit, metric)),
                   mean_of(measured.values(groups, all & ~bit, metric)), shares[i].mean,
                   half_width(shares[i]), 100 * shares[i].mean / whole});
  }
  const Estimate total = estimate_mean(measured.values(groups, all, metric));
  table.add_row({metric.name, "all", total.mean, kNone, total.mean, half_width(total), 100.0});
}

std::string draw(const Table& table, const ScoreOptions& score, const std::string& title) {
  const std::array<std::string, kBudgetMetrics.size()> titles{ate_title("mm", score.align),
                                                              rpe_title("mm", score.interval),
                                                              rpe_title("deg", score.interval)};
  std::vector<PlotPanel> panels;
  for (const BudgetMetric& metric : kBudgetMetrics) {
    PlotPanel panel{.y = {.title = titles.at(panels.size())}};
    PlotSeries alone{.name = "alone", .style = 6, .mark = PlotMark::bar, .points = {}};
    PlotSeries share{.name = "share (Shapley)", .style = 0, .mark = PlotMark::bar, .points = {}};
    for (const std::vector<TableCell>& row : table.rows) {
      if (std::get<std::string>(row[0]) == metric.name) {
        const auto x = static_cast<double>(panel.x.categories.size());
        panel.x.categories.push_back(std::get<std::string>(row[1]));
        alone.points.push_back({x, std::get<double>(row[2])});
        share.points.push_back({x, std::get<double>(row[4])});
      }
    }
    panel.series = {alone, share};
    panels.push_back(panel);
  }
  return draw_plot(title, panels);
}

/// Returns a sentence on the largest Shapley value of the ATE and the error without that group.
std::string finding(const std::vector<Group>& groups, const Measurements& measured, int seeds) {
  const BudgetMetric& ate = kBudgetMetrics.front();
  const std::vector<Estimate> shares = shares_of(groups, measured, ate, seeds);
  const auto largest =
      std::max_element(shares.begin(), shares.end(),
                       [](const Estimate& a, const Estimate& b) { return a.mean < b.mean; });
  const auto index = static_cast<std::size_t>(largest - shares.begin());
  const std::uint32_t all = all_of(groups);
  const double whole = mean_of(measured.values(groups, all, ate));
  const double rest = mean_of(measured.values(groups, all & ~(std::uint32_t{1} << index), ate));
  return vo::concat(name_of(groups[index]),
                    " causes most of the ATE: ", format_decimals(largest->mean, 2), " of ",
                    format_decimals(whole, 2), " mm; without it alone it is ",
                    format_decimals(rest, 2), " mm.");
}

std::vector<std::uint32_t> every_set(const std::vector<Group>& groups) {
  std::vector<std::uint32_t> sets;
  for (std::uint32_t set = 0; set <= all_of(groups); ++set) {
    sets.push_back(set);
  }
  return sets;
}

}  // namespace

void BudgetSettings::validate() const {
  constexpr int kMaxTop = 8;
  run.validate();
  vo::require(top >= 1 && top <= kMaxTop, "--top: expected 1 to ", kMaxTop, ", got ", top);
}

StudyReport error_budget(const Scenario& scenario, const BudgetSettings& settings,
                         const vo::Progress& progress, const vo::WaitObserver& waiting) {
  std::vector<Group> singles;
  for (const Imperfection& imperfection : find_imperfections(scenario)) {
    singles.push_back({imperfection});
  }
  vo::require(!singles.empty(), scenario.file.string(),
              ": its camera is perfect, expected options of sensor or camera.distortion");
  Measurements measured(scenario, settings, progress, waiting);
  measured.measure(singles, one_by_one(singles));
  const std::vector<Group> groups = top_groups(singles, measured, settings.top);
  measured.measure(groups, every_set(groups));

  Table table{.columns = {{"metric"},
                          {"imperfection"},
                          {"alone", 3},
                          {"without", 3},
                          {"share", 3},
                          {"share_ci95", 3},
                          {"share_percent", 1}}};
  for (const BudgetMetric& metric : kBudgetMetrics) {
    add_rows(table, groups, measured, metric, settings.run.seeds);
  }
  const std::string title = "Error budget: " + scenario.name;
  return {
      .name = "budget",
      .title = title,
      .method = vo::concat(
          "Imperfections of the camera switched on and off, ", settings.run.seeds,
          " seeds each. alone: the error with this one only; without: with all but this one; "
          "share: its Shapley value, the mean of what it adds over all orders of switching on, "
          "with half its 95 % confidence interval. Shares and the error of a perfect camera sum "
          "to the whole."),
      .table = table,
      .findings = {finding(groups, measured, settings.run.seeds)},
      .plot = draw(table, scenario.score, title),
      .more = {}};
}

}  // namespace tools
