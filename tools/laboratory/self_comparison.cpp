#include "tools/laboratory/self_comparison.h"

#include <cstddef>
#include <cstdint>
#include <utility>

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

}  // namespace

int count_false_alarms(const TestResults& results, int comparisons,
                       const ComparisonOptions& options) {
  constexpr std::size_t kMinTrials = 4;
  for (const ScenarioResult& scenario : results.scenarios) {
    vo::require(scenario.trials.size() >= kMinTrials, scenario.name, ": has ",
                scenario.trials.size(), " seeds, expected ", kMinTrials, " to split");
  }
  int count = 0;
  for (int i = 0; i < comparisons; ++i) {
    const auto [before, after] = split(results, static_cast<std::uint64_t>(i));
    count += has_alarm(compare_results(before, after, options)) ? 1 : 0;
  }
  return count;
}

}  // namespace tools
