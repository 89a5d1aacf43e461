#include "tools/laboratory/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "tools/laboratory/student_t.h"
#include "tools/plot/statistics.h"
#include "tools/plot/table.h"
#include "tools/report/report.h"
#include "vo/core/error.h"

namespace tools {
namespace {

enum class Sense { less_is_better, more_is_better, neither };

/// Properties of a metric, derived from its name.
struct MetricTraits {
  Sense sense = Sense::less_is_better;
  double negligible = 0;  ///< differences below this are never large
};

MetricTraits traits_of(const std::string& metric) {
  if (metric == "keyframes") {
    return {Sense::neither, 1};
  }
  if (metric.starts_with("nees_") || metric == "depth_nees") {
    return {Sense::neither, 0.2};
  }
  if (metric.ends_with("_fraction")) {
    return {Sense::more_is_better, 0.005};
  }
  if (metric.ends_with("_percent")) {
    return {Sense::less_is_better, 0.02};
  }
  constexpr double kAngle = 0.005;  // deg
  constexpr double kLength = 5e-5;  // m
  return {Sense::less_is_better, metric.ends_with("_deg") ? kAngle : kLength};
}

/// Samples of two results for a significance test; paired values have equal indices.
struct Samples {
  std::vector<double> before;
  std::vector<double> after;
  bool paired = true;
};

bool has_seed(const ScenarioResult& scenario, int seed) {
  return std::any_of(scenario.trials.begin(), scenario.trials.end(),
                     [&](const TrialResult& t) { return t.seed == seed && t.problem.empty(); });
}

/// Returns the scenario without the trials whose seed was not measured in the other result.
ScenarioResult common_trials(const ScenarioResult& scenario, const ScenarioResult& other) {
  ScenarioResult common = scenario;
  std::erase_if(common.trials, [&](const TrialResult& t) { return !has_seed(other, t.seed); });
  return common;
}

/// A scenario in two results, with the trials that are compared.
struct Pair {
  ScenarioResult before;
  ScenarioResult after;
  bool paired = true;          ///< trials with equal index have equal seeds
  bool same_sequences = true;  ///< paired trials tracked identical sequences
};

bool is_measured(const TrialResult& trial) {
  return trial.problem.empty();
}

Pair pair_of(const ScenarioResult& before, const ScenarioResult& after) {
  Pair pair{common_trials(before, after), common_trials(after, before)};
  pair.same_sequences = std::equal(
      pair.before.trials.begin(), pair.before.trials.end(), pair.after.trials.begin(),
      pair.after.trials.end(),
      [](const TrialResult& x, const TrialResult& y) { return x.sequence == y.sequence; });
  const auto count = [](const ScenarioResult& scenario) {
    return std::count_if(scenario.trials.begin(), scenario.trials.end(), is_measured);
  };
  if (count(pair.before) == 0 || count(pair.before) != count(pair.after)) {
    pair.before = before;
    pair.after = after;
    pair.paired = false;
  }
  return pair;
}

Share measured_share(const std::vector<double>& values) {
  const auto count =
      std::count_if(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  return {static_cast<int>(count), static_cast<int>(values.size())};
}

double ratio(const Share& share) {
  return share.of == 0 ? 0 : static_cast<double>(share.having) / share.of;
}

/// Returns the mean of the finite values; NaN without any.
double mean_of(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : spread(values).mean;
}

/// Returns the finite values; of pairs only those with both values finite.
Samples measured(const Samples& samples) {
  Samples kept{.before = {}, .after = {}, .paired = samples.paired};
  const std::size_t count = std::max(samples.before.size(), samples.after.size());
  for (std::size_t i = 0; i < count; ++i) {
    const bool was = i < samples.before.size() && std::isfinite(samples.before[i]);
    const bool is = i < samples.after.size() && std::isfinite(samples.after[i]);
    if (was && (is || !samples.paired)) {
      kept.before.push_back(samples.before[i]);
    }
    if (is && (was || !samples.paired)) {
      kept.after.push_back(samples.after[i]);
    }
  }
  return kept;
}

bool all_positive(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return v > 0; });
}

/// Returns the p-value of no difference. Errors vary by factors, so positive values are compared by
/// their logarithms, which are nearer to normal.
double p_value_of(Samples samples) {
  if (all_positive(samples.before) && all_positive(samples.after)) {
    const auto logarithm = [](double v) { return std::log(v); };
    std::transform(samples.before.begin(), samples.before.end(), samples.before.begin(), logarithm);
    std::transform(samples.after.begin(), samples.after.end(), samples.after.begin(), logarithm);
  }
  const bool is_single = samples.before.size() < 2 || samples.after.size() < 2;
  if (samples.paired) {
    return paired_p_value(samples.before, samples.after);
  }
  return is_single ? 1 : welch_p_value(samples.before, samples.after);
}

ChangeKind kind_of(double difference, Sense sense) {
  if (difference == 0) {
    return ChangeKind::none;
  }
  if (sense == Sense::neither) {
    return ChangeKind::different;
  }
  return (difference > 0) == (sense == Sense::less_is_better) ? ChangeKind::worse
                                                              : ChangeKind::better;
}

void judge_size(Change& change, const MetricTraits& traits, const ComparisonOptions& options) {
  const double difference = change.after - change.before;
  change.kind = kind_of(difference, traits.sense);
  change.percent = change.before != 0 ? 100 * difference / std::abs(change.before)
                                      : std::copysign(100.0, difference);
  const double allowed =
      change.kind == ChangeKind::worse ? options.worse_percent : options.better_percent;
  change.is_large = std::abs(difference) > traits.negligible && std::abs(change.percent) > allowed;
}

/// Judges a metric that is measured in another share of the trials; all against none needs no test.
void judge_missing(Change& change, const Share& before, const Share& after) {
  const double was = ratio(before);
  const double is = ratio(after);
  change.is_large = true;
  change.p_value = std::abs(was - is) == 1 ? 0 : fisher_p_value(before, after);
  change.kind = is < was ? ChangeKind::worse : ChangeKind::different;
  if (before.having == 0 || after.having == 0) {
    change.note = after.having == 0 ? "it can no longer be measured" : "it could not be measured";
  } else {
    change.note = vo::concat("it is measured in ", after.having, " of ", after.of,
                             " seeds, was in ", before.having, " of ", before.of);
  }
}

Change compare_metric(const Pair& pair, const std::string& metric,
                      const ComparisonOptions& options) {
  const Samples all{values_of(pair.before, metric), values_of(pair.after, metric), pair.paired};
  const Share was = measured_share(all.before);
  const Share is = measured_share(all.after);
  const Samples samples = measured(all);
  Change change{.scenario = pair.after.name, .metric = metric};
  if (ratio(was) != ratio(is)) {
    change.before = mean_of(all.before);
    change.after = mean_of(all.after);
    judge_missing(change, was, is);
    return change;
  }
  change.before = mean_of(samples.before);
  change.after = mean_of(samples.after);
  if (!samples.before.empty() && !samples.after.empty()) {
    judge_size(change, traits_of(metric), options);
    change.p_value = p_value_of(samples);
  }
  return change;
}

const ScenarioResult* find_scenario(const TestResults& results, const std::string& name) {
  const auto found = std::find_if(results.scenarios.begin(), results.scenarios.end(),
                                  [&](const ScenarioResult& s) { return s.name == name; });
  return found == results.scenarios.end() ? nullptr : &*found;
}

}  // namespace

void ComparisonOptions::validate() const {
  vo::require(level > 0 && level < 1, "level: expected between 0 and 1, got ", level);
  vo::require(worse_percent >= 0, "worse_percent: expected 0 or more, got ", worse_percent);
  vo::require(better_percent >= 0, "better_percent: expected 0 or more, got ", better_percent);
}

std::string to_text(ChangeKind kind) {
  constexpr std::array kNames{"same", "worse", "better", "different"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string describe(const Change& change) {
  std::string text = vo::concat(change.scenario, ": ", change.metric, " was ",
                                shown_number(change.before), ", is ", shown_number(change.after));
  if (change.note.empty() || std::isfinite(change.before + change.after)) {
    text += vo::concat(" (", change.percent > 0 ? "+" : "", format_decimals(change.percent, 1),
                       " %, p ", shown_number(change.p_value), "): ", to_text(change.kind));
  }
  return text + (change.note.empty() ? "" : "; " + change.note);
}

std::vector<Change> compare_results(const TestResults& before, const TestResults& after,
                                    const ComparisonOptions& options) {
  std::vector<Change> changes;
  for (const ScenarioResult& now : after.scenarios) {
    const ScenarioResult* was = find_scenario(before, now.name);
    if (was == nullptr) {
      continue;
    }
    const Pair pair = pair_of(*was, now);
    for (const auto& [metric, unused] : metric_values({})) {
      if (before.unknown_metrics.contains(metric)) {
        continue;
      }
      Change change = compare_metric(pair, metric, options);
      if (std::isnan(change.before) && std::isnan(change.after)) {
        continue;
      }
      if (!pair.same_sequences && change.note.empty()) {
        change.note = "the sequence is another one, too";
      }
      changes.push_back(std::move(change));
    }
  }
  std::vector<double> p_values;
  for (const Change& change : changes) {
    p_values.push_back(change.p_value);
  }
  const std::vector<bool> significant = holm_rejections(p_values, options.level);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    changes[i].is_significant = significant[i];
  }
  return changes;
}

bool has_alarm(const std::vector<Change>& changes) {
  return std::any_of(changes.begin(), changes.end(),
                     [](const Change& change) { return change.is_alarm(); });
}

std::vector<std::string> missing_scenarios(const TestResults& among, const TestResults& from) {
  std::vector<std::string> names;
  for (const ScenarioResult& scenario : among.scenarios) {
    if (find_scenario(from, scenario.name) == nullptr) {
      names.push_back(scenario.name);
    }
  }
  return names;
}

TestResults updated(const TestResults& old, const TestResults& results) {
  TestResults merged = results;
  std::copy_if(old.scenarios.begin(), old.scenarios.end(), std::back_inserter(merged.scenarios),
               [&](const ScenarioResult& scenario) {
                 return find_scenario(results, scenario.name) == nullptr;
               });
  std::sort(merged.scenarios.begin(), merged.scenarios.end(),
            [](const ScenarioResult& a, const ScenarioResult& b) { return a.name < b.name; });
  return merged;
}

}  // namespace tools
