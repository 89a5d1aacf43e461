#include "tools/laboratory/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "tools/laboratory/metric_traits.h"
#include "tools/laboratory/trial_pairs.h"
#include "tools/plot/statistics.h"
#include "tools/plot/table.h"
#include "tools/report/report.h"
#include "tools/statistics/difference_test.h"
#include "tools/statistics/significance.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Standard deviation below which logarithms of ratios are not believed to agree.
constexpr double kLeastLogDeviation = 1e-6;

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
  change.is_large =
      std::abs(difference) > traits.resolution.negligible && std::abs(change.percent) > allowed;
}

/// Returns the p-value of a metric's being measured as often as before. That no seed of the later
/// result has it is a finding, not a matter of chance: nothing is left to compare. Nor is there
/// chance in a single seed.
double availability_p_value(const Share& before, const Share& after) {
  const bool is_lost = after.having == 0 && before.having > 0;
  return is_lost || (before.of == 1 && after.of == 1) ? 0 : fisher_p_value(before, after);
}

/// Returns the change of the share of trials in which a metric is measured.
Change availability_change(const Change& named, const Samples& all) {
  const Share before = measured_share(all.before);
  const Share after = measured_share(all.after);
  Change change = named;
  change.before = mean_of(all.before);
  change.after = mean_of(all.after);
  change.p_value = availability_p_value(before, after);
  change.kind = ratio(after) < ratio(before) ? ChangeKind::worse : ChangeKind::different;
  change.is_large = true;
  if (before.having == 0 || after.having == 0) {
    change.note = after.having == 0 ? "it can no longer be measured" : "it could not be measured";
  } else {
    change.note = vo::concat("it is measured in ", after.having, " of ", after.of,
                             " seeds, was in ", before.having, " of ", before.of);
  }
  return change;
}

/// Returns the change of a metric's mean over the trials that have it.
Change value_change(const Change& named, const Samples& samples, const MetricTraits& traits,
                    const ComparisonOptions& options) {
  Change change = named;
  change.before = mean_of(samples.before);
  change.after = mean_of(samples.after);
  judge_size(change, traits, options);
  const DifferenceTest test = test_difference(samples, traits.resolution);
  change.p_value = test.p_value;
  change.least_p_value = test.least_p_value;
  return change;
}

/// The hypotheses that one metric of one scenario is tested by: its values did not change, and it
/// is measured as often as before. The second is tested only if the shares differ, the first if
/// there are values to compare; without either the metric was not measured.
struct MetricChange {
  std::optional<Change> value;
  std::optional<Change> availability;
};

MetricChange compare_metric(const Change& named, const Samples& all, std::size_t frames,
                            const ComparisonOptions& options) {
  MetricChange change;
  if (ratio(measured_share(all.before)) != ratio(measured_share(all.after))) {
    change.availability = availability_change(named, all);
  }
  Samples samples = measured(all);
  const bool is_one_of_several = samples.before.size() == 1 && all.before.size() > 1;
  samples.paired = samples.paired && !is_one_of_several;  // a sample of one, which says nothing
  if (!samples.before.empty() && !samples.after.empty()) {
    change.value = value_change(named, samples, traits_of(named.metric, frames), options);
  }
  return change;
}

/// Returns the metrics of one scenario that both results know and one of them measured.
std::vector<MetricChange> compare_scenario(const ScenarioResult& before,
                                           const ScenarioResult& after,
                                           const std::set<std::string>& unknown,
                                           const ComparisonOptions& options) {
  const TrialPairs pairs = pair_trials(before, after);
  const std::size_t frames = pairs.after.empty() ? 0 : pairs.after.front()->frames;
  std::vector<MetricChange> changes;
  for (const auto& [metric, samples] : samples_of(pairs)) {
    if (unknown.contains(metric)) {
      continue;
    }
    const Change named{.scenario = after.name, .metric = metric};
    MetricChange change = compare_metric(named, samples, frames, options);
    if (change.value && !pairs.same_sequences) {
      change.value->note = "the sequence is another one, too";
    }
    if (change.value || change.availability) {
      changes.push_back(std::move(change));
    }
  }
  return changes;
}

std::vector<Change*> hypotheses_of(std::vector<MetricChange>& changes) {
  std::vector<Change*> hypotheses;
  for (MetricChange& change : changes) {
    for (std::optional<Change>* tested : {&change.value, &change.availability}) {
      if (*tested) {
        hypotheses.push_back(&**tested);
      }
    }
  }
  return hypotheses;
}

/// Marks the changes that are significant among all of them, and those that cannot be.
void judge_significance(const std::vector<Change*>& hypotheses, double level) {
  std::vector<double> p_values;
  for (const Change* change : hypotheses) {
    p_values.push_back(change->p_value);
  }
  const std::vector<bool> significant = holm_rejections(p_values, level);
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    hypotheses[i]->is_significant = significant[i];
    hypotheses[i]->has_too_few_seeds =
        hypotheses[i]->least_p_value > level / static_cast<double>(hypotheses.size());
  }
}

/// Returns how bad a change is, to choose among those of one metric.
int severity(const Change& change) {
  return (change.is_alarm() ? 2 : 0) + (change.kind == ChangeKind::worse ? 1 : 0);
}

/// Returns the worse of a metric's changes, with the notes of both.
Change worse_of(const MetricChange& metric) {
  if (!metric.value || !metric.availability) {
    return metric.value ? *metric.value : *metric.availability;
  }
  const bool is_value = severity(*metric.value) >= severity(*metric.availability);
  Change change = is_value ? *metric.value : *metric.availability;
  change.note = metric.availability->note;
  if (!metric.value->note.empty()) {
    change.note += "; " + metric.value->note;
  }
  return change;
}

/// Adds the pairs of one scenario that say something of its errors. A value below what is
/// negligible is taken for that; where both are, nothing can be said.
void add_pairs(const Samples& samples, double negligible, Samples& pooled) {
  for (std::size_t i = 0; i < samples.before.size(); ++i) {
    if (std::max(samples.before[i], samples.after[i]) > negligible) {
      pooled.before.push_back(std::max(samples.before[i], negligible));
      pooled.after.push_back(std::max(samples.after[i], negligible));
    }
  }
}

/// Returns the pairs of each error metric over all scenarios. Only scenarios of several seeds have
/// chance in them.
std::map<std::string, Samples> pooled_samples(const TestResults& before, const TestResults& after) {
  std::map<std::string, Samples> pooled;
  for (const auto& [was, now] : common_scenarios(before, after)) {
    const TrialPairs pairs = pair_trials(*was, *now);
    if (!pairs.paired || pairs.before.size() < 2) {
      continue;
    }
    for (const auto& [metric, samples] : samples_of(pairs)) {
      const MetricTraits traits = traits_of(metric, 0);
      if (traits.sense == Sense::less_is_better && !before.unknown_metrics.contains(metric)) {
        add_pairs(measured(samples), traits.resolution.negligible, pooled[metric]);
      }
    }
  }
  return pooled;
}

/// Returns the logarithms of positive values.
std::vector<double> logarithms(std::vector<double> values) {
  std::transform(values.begin(), values.end(), values.begin(),
                 [](double value) { return std::log(value); });
  return values;
}

/// Returns the change of one metric's geometric mean over the trials of all scenarios.
MetricChange pooled_change(const std::string& metric, const Samples& samples,
                           const ComparisonOptions& options) {
  const std::vector<double> before = logarithms(samples.before);
  const std::vector<double> after = logarithms(samples.after);
  Change change{.scenario = kAllScenarios, .metric = metric};
  change.before = std::exp(mean_of(before));
  change.after = std::exp(mean_of(after));
  judge_size(change, traits_of(metric, 0), options);
  change.p_value = paired_p_value(before, after, kLeastLogDeviation);
  change.note = vo::concat("geometric means over ", before.size(), " trials");
  return {.value = change, .availability = {}};
}

/// Compares the error metrics over the trials of all scenarios together, if there are several:
/// what makes each trial a little worse shows there first.
std::vector<MetricChange> compare_pooled(const TestResults& before, const TestResults& after,
                                         const ComparisonOptions& options) {
  constexpr std::size_t kFewest = 6;
  std::vector<MetricChange> changes;
  if (common_scenarios(before, after).size() < 2) {
    return changes;
  }
  for (const auto& [metric, samples] : pooled_samples(before, after)) {
    if (samples.before.size() >= kFewest) {
      changes.push_back(pooled_change(metric, samples, options));
    }
  }
  return changes;
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
  std::vector<MetricChange> metrics;
  for (const auto& [was, now] : common_scenarios(before, after)) {
    std::vector<MetricChange> found = compare_scenario(*was, *now, before.unknown_metrics, options);
    std::move(found.begin(), found.end(), std::back_inserter(metrics));
  }
  std::vector<MetricChange> pooled = compare_pooled(before, after, options);
  std::move(pooled.begin(), pooled.end(), std::back_inserter(metrics));
  judge_significance(hypotheses_of(metrics), options.level);
  std::vector<Change> changes;
  std::transform(metrics.begin(), metrics.end(), std::back_inserter(changes), worse_of);
  return changes;
}

std::vector<std::pair<const ScenarioResult*, const ScenarioResult*>> common_scenarios(
    const TestResults& before, const TestResults& after) {
  std::vector<std::pair<const ScenarioResult*, const ScenarioResult*>> common;
  for (const ScenarioResult& now : after.scenarios) {
    if (const ScenarioResult* was = find_scenario(before, now.name)) {
      common.emplace_back(was, &now);
    }
  }
  return common;
}

std::vector<std::string> alarms_of(const std::string& scenario,
                                   const std::vector<Change>& changes) {
  std::vector<std::string> sentences;
  for (const Change& change : changes) {
    if (change.is_alarm() && change.scenario == scenario) {
      sentences.push_back(describe(change));
    }
  }
  return sentences;
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
  merged.scenarios.clear();
  for (const TestResults* from : {&results, &old}) {
    std::copy_if(from->scenarios.begin(), from->scenarios.end(),
                 std::back_inserter(merged.scenarios), [&](const ScenarioResult& scenario) {
                   return find_scenario(merged, scenario.name) == nullptr;
                 });
  }
  std::sort(merged.scenarios.begin(), merged.scenarios.end(),
            [](const ScenarioResult& a, const ScenarioResult& b) { return a.name < b.name; });
  return merged;
}

}  // namespace tools
