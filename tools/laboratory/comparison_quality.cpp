#include "tools/laboratory/comparison_quality.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "tools/laboratory/trial_pairs.h"
#include "tools/plot/statistics.h"
#include "tools/statistics/power.h"
#include "vo/core/error.h"
#include "vo/core/hash.h"

namespace tools {
namespace {

/// Shuffles the trials with the Fisher-Yates algorithm.
void shuffle(std::vector<TrialResult>& trials, std::uint64_t seed) {
  for (std::size_t i = trials.size(); i > 1; --i) {
    const double uniform = vo::random_uniform({seed, i});
    std::swap(trials[i - 1], trials[static_cast<std::size_t>(uniform * static_cast<double>(i))]);
  }
}

/// Splits every scenario's trials at random into two results.
std::pair<TestResults, TestResults> split(const TestResults& results, std::uint64_t seed) {
  std::pair<TestResults, TestResults> halves{results, results};
  for (std::size_t i = 0; i < results.scenarios.size(); ++i) {
    std::vector<TrialResult> trials = results.scenarios[i].trials;
    shuffle(trials, vo::mixed(seed) + i);
    const auto middle = trials.begin() + static_cast<std::ptrdiff_t>(trials.size() / 2);
    halves.first.scenarios[i].trials.assign(trials.begin(), middle);
    halves.second.scenarios[i].trials.assign(middle, trials.end());
  }
  return halves;
}

bool all_positive(const Samples& samples) {
  const auto is_positive = [](double value) { return value > 0; };
  return std::all_of(samples.before.begin(), samples.before.end(), is_positive) &&
         std::all_of(samples.after.begin(), samples.after.end(), is_positive);
}

/// Returns the metric's samples in a scenario of both results; empty if they are too few to have a
/// spread.
Samples samples_of_metric(const ScenarioResult& before, const ScenarioResult& after,
                          const std::string& metric) {
  constexpr std::size_t kMinSeeds = 3;
  const TrialPairs pairs = pair_trials(before, after);
  for (const auto& [name, all] : samples_of(pairs)) {
    Samples samples = measured(all);
    const bool has_spread = samples.paired && samples.before.size() >= kMinSeeds;
    if (name == metric && has_spread && all_positive(samples)) {
      return samples;
    }
  }
  return {};
}

ComparisonDesign design_of(const Samples& samples, Seeds seeds, double level,
                           double worse_percent) {
  std::vector<double> logarithms;
  std::vector<double> changes;
  for (std::size_t i = 0; i < samples.before.size(); ++i) {
    logarithms.push_back(std::log(samples.before[i]));
    changes.push_back(std::log(samples.after[i] / samples.before[i]));
  }
  return {.deviation = spread(logarithms).deviation,
          .pair_deviation = spread(changes).deviation,
          .paired = seeds == Seeds::same,
          .level = level,
          .least_factor = 1 + worse_percent / 100};
}

}  // namespace

int count_false_alarms(const TestResults& results, int comparisons,
                       const ComparisonOptions& options, const vo::Progress& progress) {
  constexpr std::size_t kMinTrials = 4;
  for (const ScenarioResult& scenario : results.scenarios) {
    vo::require(scenario.trials.size() >= kMinTrials, scenario.name, ": has ",
                scenario.trials.size(), " seeds, expected ", kMinTrials, " to split");
  }
  int count = 0;
  const auto total = static_cast<std::size_t>(comparisons);
  for (std::size_t i = 0; i < total; ++i) {
    const auto [before, after] = split(results, i);
    count += has_alarm(compare_results(before, after, options)) ? 1 : 0;
    progress(i + 1, total);
  }
  return count;
}

std::vector<DetectableChange> detectable_changes(const TestResults& before,
                                                 const TestResults& after,
                                                 const std::string& metric, Seeds seeds,
                                                 const ComparisonOptions& options) {
  constexpr double kPower = 0.9;
  constexpr int kDraws = 1000;
  const auto known = metric_values({});
  vo::require(std::any_of(known.begin(), known.end(),
                          [&](const auto& value) { return value.first == metric; }),
              metric, ": there is no such metric");
  const std::vector<Change> family = compare_results(before, after, options);
  vo::require(!family.empty(), "the two results have no scenario in common");
  const double level = options.level / static_cast<double>(family.size());
  std::vector<DetectableChange> changes;
  for (const auto& [was, now] : common_scenarios(before, after)) {
    const Samples samples = samples_of_metric(*was, *now, metric);
    if (samples.before.empty()) {
      continue;
    }
    ComparisonDesign design = design_of(samples, seeds, level, options.worse_percent);
    DetectableChange change{
        .scenario = now->name,
        .seeds = samples.before.size(),
        .deviation = seeds == Seeds::same ? design.pair_deviation : design.deviation};
    for (std::size_t i = 0; i < kPowerSeeds.size(); ++i) {
      design.seeds = kPowerSeeds[i];
      change.percent[i] = 100 * (detectable_factor(design, kPower, kDraws) - 1);
    }
    changes.push_back(change);
  }
  return changes;
}

}  // namespace tools
