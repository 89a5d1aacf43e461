#include "tools/laboratory/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tools/laboratory/self_comparison.h"
#include "vo/core/random.h"

namespace {

using testing::HasSubstr;
using tools::Change;
using tools::ScenarioResult;
using tools::TestResults;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

tools::Metrics errors_of(double ate, double rpe, double rotation) {
  tools::Metrics metrics = tools::make_metrics([](const std::string&) { return kUnknown; });
  metrics.ate_rmse_m = ate;
  metrics.rpe_translation_rmse_m = rpe;
  metrics.rpe_rotation_rmse_deg = rotation;
  metrics.tracked_fraction = 1;
  return metrics;
}

TestResults results_of(const std::vector<double>& ate) {
  ScenarioResult scenario{.name = "orbit"};
  for (std::size_t i = 0; i < ate.size(); ++i) {
    scenario.trials.push_back({.seed = static_cast<int>(i),
                               .sequence = std::to_string(i),
                               .metrics = errors_of(ate[i], 0.01, 0.1)});
  }
  return {.tracker = "edvo", .scenarios = {scenario}};
}

std::vector<Change> alarms(const TestResults& before, const TestResults& after,
                           const tools::ComparisonOptions& options = {}) {
  std::vector<Change> changes = tools::compare_results(before, after, options);
  std::erase_if(changes, [](const Change& change) { return !change.is_alarm(); });
  return changes;
}

TEST(Comparison, AResultIsTheSameAsItself) {
  const TestResults results = results_of({0.01, 0.02, 0.015});
  EXPECT_TRUE(alarms(results, results).empty());
}

TEST(Comparison, ALossThatEverySeedShowsIsNamed) {
  const std::vector<Change> found =
      alarms(results_of({0.010, 0.020, 0.015, 0.012}), results_of({0.0121, 0.024, 0.0181, 0.0144}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, tools::ChangeKind::worse);
  EXPECT_THAT(tools::describe(found[0]),
              HasSubstr("orbit: ate_rmse_m was 0.01425, is 0.01715 (+20.4 %, p "));
}

TEST(Comparison, AGainIsAnAlarmOnlyWhenItIsLarge) {
  EXPECT_TRUE(alarms(results_of({0.010}), results_of({0.008})).empty()) << "20 % better";
  const std::vector<Change> found = alarms(results_of({0.010}), results_of({0.006}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, tools::ChangeKind::better);
}

TEST(Comparison, AChangeWithinTheSpreadOfSeedsIsChance) {
  EXPECT_TRUE(alarms(results_of({0.010, 0.020, 0.015}), results_of({0.019, 0.011, 0.025})).empty())
      << "22 % worse in the mean";
}

TEST(Comparison, ASmallChangeIsNoAlarmHoweverSure) {
  EXPECT_TRUE(alarms(results_of({0.010}), results_of({0.0109})).empty());
  EXPECT_TRUE(alarms(results_of({1e-6}), results_of({4e-5})).empty()) << "below 0.05 mm";
}

TEST(Comparison, WhatCanNoLongerBeMeasuredIsAnAlarm) {
  TestResults after = results_of({0.010});
  after.scenarios[0].trials[0].metrics.ate_rmse_m = kUnknown;
  const std::vector<Change> found = alarms(results_of({0.010}), after);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(tools::describe(found[0]), HasSubstr("it can no longer be measured"));
}

TEST(Comparison, AMetricThatTheEarlierResultsDoNotKnowIsNotCompared) {
  TestResults before = results_of({0.01, 0.02});
  before.scenarios[0].trials[0].metrics.keyframes = kUnknown;
  TestResults after = before;
  after.scenarios[0].trials[0].metrics.nees_p90 = 2;
  after.scenarios[0].trials[1].metrics.nees_p90 = 3;
  EXPECT_EQ(alarms(before, after).size(), 1U) << "known and not measured before";
  before.unknown_metrics = {"nees_p90"};
  EXPECT_TRUE(alarms(before, after).empty());
}

TEST(Comparison, ASeedThatCannotBeMeasuredIsNoAlarmByItself) {
  const TestResults all = results_of({0.010, 0.012, 0.011, 0.013, 0.010});
  TestResults some = results_of({0.010, 0.012, 0.011, 0.013, kUnknown});
  EXPECT_TRUE(alarms(all, some).empty()) << "one of five may be chance";
  const std::vector<Change> changes = tools::compare_results(all, some, {});
  EXPECT_THAT(changes.front().note, HasSubstr("measured in 4 of 5 seeds, was in 5 of 5"));
  EXPECT_TRUE(alarms(some, some).empty());
  EXPECT_EQ(alarms(some, results_of({0.020, 0.024, 0.0221, 0.026, kUnknown})).size(), 1U)
      << "those that are measured are compared";
}

TEST(Comparison, FarFewerMeasuredSeedsAreAnAlarm) {
  const std::vector<double> errors(8, 0.010);
  std::vector<double> fewer(8, kUnknown);
  fewer[0] = 0.010;
  const std::vector<Change> found = alarms(results_of(errors), results_of(fewer));
  ASSERT_EQ(found.size(), 1U) << "one of eight, by Fisher's test 0.0014";
  EXPECT_EQ(found[0].kind, tools::ChangeKind::worse);
}

TEST(Comparison, SequencesThatChangedAreSaid) {
  TestResults after = results_of({0.02});
  after.scenarios[0].trials[0].sequence = "other";
  const std::vector<Change> found = alarms(results_of({0.01}), after);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].note, HasSubstr("the sequence is another one"));
}

/// Seeds of three scenarios whose errors spread by a factor, as those of trackers do.
TestResults random_results(vo::Random& random, int first_seed, int seeds) {
  const auto factor = [&random](double spread) { return std::exp(spread * random.normal()); };
  TestResults results{.tracker = "edvo", .scenarios = {}};
  for (const char* name : {"still", "orbit", "fast"}) {
    ScenarioResult scenario{.name = name};
    for (int seed = first_seed; seed < first_seed + seeds; ++seed) {
      scenario.trials.push_back(
          {.seed = seed,
           .metrics = errors_of(0.005 * factor(0.3), 0.008 * factor(0.2), 0.2 * factor(0.4))});
    }
    results.scenarios.push_back(scenario);
  }
  return results;
}

constexpr tools::ComparisonOptions kEverySize{
    .level = 0.01, .worse_percent = 0, .better_percent = 0};

int count_alarms(int comparisons, int seed_of_second, std::uint64_t first_random) {
  constexpr int kSeeds = 5;
  vo::Random random(first_random);
  int count = 0;
  for (int i = 0; i < comparisons; ++i) {
    const TestResults before = random_results(random, 0, kSeeds);
    const TestResults after = random_results(random, seed_of_second, kSeeds);
    count += alarms(before, after, kEverySize).empty() ? 0 : 1;
  }
  return count;
}

TEST(Comparison, ABuildAgainstItselfRaisesFalseAlarmsAtTheStatedRate) {
  EXPECT_LE(count_alarms(200, 5, 1), 2) << "other seeds, 1 %";
  EXPECT_LE(count_alarms(200, 0, 2), 2) << "the same seeds, 1 %";
  EXPECT_NEAR(count_alarms(1000, 5, 3), 10, 9.5) << "three standard deviations of a count of 10";
  EXPECT_NEAR(count_alarms(1000, 0, 4), 10, 9.5);
}

TEST(Comparison, HalvesOfOneResultRaiseNoMoreAlarmsThanTheLevelAllows) {
  vo::Random random(5);
  EXPECT_LE(tools::count_false_alarms(random_results(random, 0, 12), 200, kEverySize), 2);
}

TEST(Comparison, HalvesNeedSeeds) {
  EXPECT_THAT(support::error_text([] {
                tools::count_false_alarms(results_of({0.1, 0.2, 0.3}), 1, kEverySize);
              }),
              HasSubstr("orbit: has 3 seeds, expected 4 to split"));
}

}  // namespace
