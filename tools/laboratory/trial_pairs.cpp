#include "tools/laboratory/trial_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tools {
namespace {

using Trials = std::vector<const TrialResult*>;

const TrialResult* find_seed(const ScenarioResult& scenario, int seed) {
  const auto found = std::find_if(scenario.trials.begin(), scenario.trials.end(),
                                  [&](const TrialResult& trial) { return trial.seed == seed; });
  return found == scenario.trials.end() ? nullptr : &*found;
}

Trials all_trials(const ScenarioResult& scenario) {
  Trials trials;
  for (const TrialResult& trial : scenario.trials) {
    trials.push_back(&trial);
  }
  return trials;
}

bool is_measured(const TrialResult& trial) {
  return trial.problem.empty();
}

bool is_same_value(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool repeats(const TrialResult& trial, const TrialResult& other) {
  if (trial.sequence.empty() || trial.sequence != other.sequence || !is_measured(trial) ||
      !is_measured(other)) {
    return false;
  }
  const auto values = metric_values(trial.metrics);
  const auto others = metric_values(other.metrics);
  return std::equal(values.begin(), values.end(), others.begin(),
                    [](const auto& a, const auto& b) { return is_same_value(a.second, b.second); });
}

/// Returns the trials without those that repeat an earlier one.
Trials distinct(const Trials& trials) {
  Trials kept;
  for (const TrialResult* trial : trials) {
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const TrialResult* earlier) { return repeats(*trial, *earlier); })) {
      kept.push_back(trial);
    }
  }
  return kept;
}

/// Adds a pair of trials unless both repeat those of an earlier pair.
void add_distinct(const TrialResult& before, const TrialResult& after, TrialPairs& pairs) {
  for (std::size_t i = 0; i < pairs.before.size(); ++i) {
    if (repeats(before, *pairs.before[i]) && repeats(after, *pairs.after[i])) {
      return;
    }
  }
  pairs.before.push_back(&before);
  pairs.after.push_back(&after);
  if (is_measured(before) && is_measured(after)) {
    pairs.same_sequences = pairs.same_sequences && before.sequence == after.sequence;
  }
}

/// Adds each trial's values to those of the metrics.
void add_values(const Trials& trials, std::vector<double> Samples::*side,
                std::vector<std::pair<std::string, Samples>>& metrics) {
  for (const TrialResult* trial : trials) {
    const auto values = metric_values(trial->metrics);
    for (std::size_t i = 0; i < metrics.size(); ++i) {
      (metrics[i].second.*side)
          .push_back(is_measured(*trial) ? values[i].second
                                         : std::numeric_limits<double>::quiet_NaN());
    }
  }
}

}  // namespace

TrialPairs pair_trials(const ScenarioResult& before, const ScenarioResult& after) {
  TrialPairs pairs;
  for (const TrialResult& trial : before.trials) {
    if (const TrialResult* other = find_seed(after, trial.seed)) {
      add_distinct(trial, *other, pairs);
    }
  }
  if (pairs.before.empty()) {
    pairs.before = distinct(all_trials(before));
    pairs.after = distinct(all_trials(after));
    pairs.paired = false;
  }
  return pairs;
}

std::vector<std::pair<std::string, Samples>> samples_of(const TrialPairs& pairs) {
  std::vector<std::pair<std::string, Samples>> metrics;
  for (const auto& [metric, unused] : metric_values({})) {
    metrics.emplace_back(metric, Samples{.before = {}, .after = {}, .paired = pairs.paired});
  }
  add_values(pairs.before, &Samples::before, metrics);
  add_values(pairs.after, &Samples::after, metrics);
  return metrics;
}

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

}  // namespace tools
