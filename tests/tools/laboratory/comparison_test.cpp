#include "tools/laboratory/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tools/laboratory/comparison_quality.h"
#include "vo/core/random.h"

namespace {

using testing::HasSubstr;
using tools::Change;
using tools::ScenarioResult;
using tools::Seeds;
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
  TestResults before = results_of(std::vector<double>(8, 0.01));
  TestResults after = before;
  for (std::size_t i = 0; i < 8; ++i) {
    before.scenarios[0].trials[i].metrics.keyframes = kUnknown;
    after.scenarios[0].trials[i].metrics.keyframes = kUnknown;
    after.scenarios[0].trials[i].metrics.nees_p90 = 2;
  }
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

/// Twelve seeds whose errors vary, times a factor.
std::vector<double> twelve_errors(double factor) {
  vo::Random random(7);
  std::vector<double> errors;
  for (int i = 0; i < 12; ++i) {
    errors.push_back(factor * 0.01 * std::exp(0.2 * random.normal()));
  }
  return errors;
}

TEST(Comparison, ALossIsFoundThoughASeedCannotBeMeasured) {
  std::vector<double> after = twelve_errors(5);
  after[3] = kUnknown;
  const std::vector<Change> found = alarms(results_of(twelve_errors(1)), results_of(after));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, tools::ChangeKind::worse);
  EXPECT_NEAR(found[0].percent, 400, 1e-9) << "of the eleven that both have";
  EXPECT_THAT(tools::describe(found[0]),
              HasSubstr("worse; it is measured in 11 of 12 seeds, was in 12 of 12"));
}

TEST(Comparison, ALossIsFoundThoughASeedEndedWithAProblem) {
  TestResults after = results_of(twelve_errors(5));
  after.scenarios[0].trials[3].problem = "the tracker ended with exit code 139";
  const std::vector<Change> found = alarms(results_of(twelve_errors(1)), after);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].metric, "ate_rmse_m");
}

TEST(Comparison, OfAGainAndFewerMeasuredSeedsTheLatterIsReported) {
  std::vector<double> after = twelve_errors(0.2);
  std::fill_n(after.begin(), 9, kUnknown);
  const std::vector<Change> found = alarms(results_of(twelve_errors(1)), results_of(after));
  ASSERT_EQ(found.size(), 1U) << "three of twelve, by Fisher's test 0.0003";
  EXPECT_EQ(found[0].kind, tools::ChangeKind::worse);
  EXPECT_THAT(found[0].note, HasSubstr("measured in 3 of 12 seeds"));
}

TEST(Comparison, OneSeedThatIsLeftOfSeveralSaysNothing) {
  const std::vector<Change> changes =
      tools::compare_results(results_of({0.010, 0.012}), results_of({0.015, kUnknown}), {});
  EXPECT_FALSE(tools::has_alarm(changes));
  EXPECT_EQ(changes.front().p_value, 1);
  EXPECT_TRUE(changes.front().has_too_few_seeds);
}

TEST(Comparison, WhatNoSeedHasAnyMoreIsAnAlarmHoweverFewTheyAre) {
  const std::vector<Change> found =
      alarms(results_of({0.010, 0.012, 0.011}), results_of({kUnknown, kUnknown, kUnknown}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].note, HasSubstr("it can no longer be measured"));
}

/// Returns results with these numbers of keyframes, and nothing else measured.
TestResults keyframe_results(const std::vector<double>& keyframes) {
  TestResults results = results_of(std::vector<double>(keyframes.size(), kUnknown));
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    tools::Metrics& metrics = results.scenarios[0].trials[i].metrics;
    metrics = tools::make_metrics([](const std::string&) { return kUnknown; });
    metrics.keyframes = keyframes[i];
  }
  return results;
}

TEST(Comparison, EqualCountsOfFewSeedsAreTooFewToTell) {
  const std::vector<Change> changes =
      tools::compare_results(keyframe_results({5, 5}), keyframe_results({9, 9}), {});
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].p_value, 0.5);
  EXPECT_TRUE(changes[0].is_large && changes[0].has_too_few_seeds);
  EXPECT_FALSE(changes[0].is_alarm());
  EXPECT_EQ(alarms(keyframe_results(std::vector<double>(12, 5)),
                   keyframe_results(std::vector<double>(12, 9)))
                .size(),
            1U)
      << "p = 2^-11";
}

TEST(Comparison, SeedsThatChangeNothingAreOneTrial) {
  const auto noiseless = [](double ate) {
    TestResults results = results_of(std::vector<double>(3, ate));
    for (tools::TrialResult& trial : results.scenarios[0].trials) {
      trial.sequence = "the same";
    }
    return results;
  };
  const std::vector<Change> found = alarms(noiseless(0.01), noiseless(0.012));
  ASSERT_EQ(found.size(), 1U) << "a single sequence has no chance in it";
  EXPECT_EQ(found[0].p_value, 0);
}

TEST(Comparison, SequencesThatChangedAreSaid) {
  TestResults after = results_of({0.02});
  after.scenarios[0].trials[0].sequence = "other";
  const std::vector<Change> found = alarms(results_of({0.01}), after);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].note, HasSubstr("the sequence is another one"));
}

/// Draws metrics that spread from seed to seed as those of trackers do: errors by a factor, counts
/// of keyframes and of tracked frames over a few values.
tools::Metrics random_metrics(vo::Random& random) {
  const auto factor = [&random](double spread) { return std::exp(spread * random.normal()); };
  tools::Metrics metrics = errors_of(0.005 * factor(0.3), 0.008 * factor(0.2), 0.2 * factor(0.4));
  metrics.keyframes = 5 + random.below(3);
  metrics.tracked_fraction = random.below(2) == 0 ? 1 : (55 + random.below(5)) / 60.0;
  return metrics;
}

TestResults random_results(vo::Random& random, int first_seed, int seeds) {
  TestResults results{.tracker = "edvo", .scenarios = {}};
  for (const char* name : {"still", "orbit", "fast"}) {
    ScenarioResult scenario{.name = name};
    for (int seed = first_seed; seed < first_seed + seeds; ++seed) {
      scenario.trials.push_back({.seed = seed, .frames = 60, .metrics = random_metrics(random)});
    }
    results.scenarios.push_back(scenario);
  }
  return results;
}

const vo::Progress kIgnored = [](std::size_t, std::size_t) {};

constexpr tools::ComparisonOptions kEverySize{
    .level = 0.01, .worse_percent = 0, .better_percent = 0};

int count_alarms(int comparisons, int seeds, Seeds of_second, std::uint64_t first_random) {
  vo::Random random(first_random);
  int count = 0;
  for (int i = 0; i < comparisons; ++i) {
    const TestResults before = random_results(random, 0, seeds);
    const TestResults after = random_results(random, of_second == Seeds::same ? 0 : seeds, seeds);
    count += alarms(before, after, kEverySize).empty() ? 0 : 1;
  }
  return count;
}

TEST(Comparison, ABuildAgainstItselfRaisesNoMoreFalseAlarmsThanStated) {
  constexpr int kComparisons = 400;
  constexpr int kMost = 10;  // three standard deviations above a count of 4
  for (const int seeds : {2, 3, 5, 12}) {
    EXPECT_LE(count_alarms(kComparisons, seeds, Seeds::same, 1), kMost) << seeds;
    EXPECT_LE(count_alarms(kComparisons, seeds, Seeds::other, 2), kMost) << seeds;
  }
}

TEST(Comparison, HalvesOfOneResultRaiseNoMoreAlarmsThanTheLevelAllows) {
  vo::Random random(5);
  EXPECT_LE(tools::count_false_alarms(random_results(random, 0, 12), 200, kEverySize, kIgnored), 2);
}

TEST(Comparison, TheGrowthThatIsFoundIsAnAlarmWhenItIsPlanted) {
  vo::Random random(6);
  const TestResults before = random_results(random, 0, 12);
  const TestResults after = random_results(random, 0, 12);
  const std::vector<tools::DetectableChange> found =
      tools::detectable_changes(before, after, "ate_rmse_m", Seeds::same, {});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[0].deviation, 0.3 * std::numbers::sqrt2, 0.15);
  int count = 0;
  for (int i = 0; i < 100; ++i) {
    const TestResults was = random_results(random, 0, 12);
    TestResults grown = random_results(random, 0, 12);
    for (std::size_t k = 0; k < 12; ++k) {
      grown.scenarios[0].trials[k].metrics.ate_rmse_m =
          was.scenarios[0].trials[k].metrics.ate_rmse_m * (1 + found[0].percent.back() / 100) *
          std::exp(found[0].deviation * random.normal());
    }
    count += alarms(was, grown).empty() ? 0 : 1;
  }
  EXPECT_NEAR(count, 90, 12) << "four standard deviations";
}

TEST(Comparison, HalvesNeedSeeds) {
  EXPECT_THAT(support::error_text([] {
                tools::count_false_alarms(results_of({0.1, 0.2, 0.3}), 1, kEverySize, kIgnored);
              }),
              HasSubstr("orbit: has 3 seeds, expected 4 to split"));
}

TEST(Comparison, ABaselineHasEachScenarioOnce) {
  TestResults twice = results_of({0.1, 0.2});
  twice.scenarios.push_back(results_of({0.3}).scenarios.front());
  TestResults old = results_of({0.4});
  old.scenarios.push_back({.name = "another"});
  const TestResults merged = tools::updated(old, twice);
  ASSERT_EQ(merged.scenarios.size(), 2U);
  EXPECT_EQ(merged.scenarios[0].name, "another");
  EXPECT_EQ(merged.scenarios[1].trials.size(), 2U) << "the first of those that were measured";
}

/// Four scenarios of five seeds, whose errors are a factor that varies a little times the same.
TestResults several_scenarios(double factor, std::uint64_t seed) {
  vo::Random random(seed);
  TestResults results{.tracker = "edvo"};
  for (int i = 0; i < 4; ++i) {
    ScenarioResult scenario = results_of({0.01, 0.02, 0.015, 0.012, 0.03}).scenarios.front();
    scenario.name = "scenario" + std::to_string(i);
    for (tools::TrialResult& trial : scenario.trials) {
      trial.metrics.ate_rmse_m *= factor * std::exp(0.1 * random.normal());
    }
    results.scenarios.push_back(scenario);
  }
  return results;
}

TEST(Comparison, WhatMakesEveryTrialALittleWorseIsFoundOverAllScenariosTogether) {
  const TestResults before = several_scenarios(1, 1);
  const std::vector<Change> found = alarms(before, several_scenarios(1.2, 2));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].scenario, tools::kAllScenarios);
  EXPECT_EQ(found[0].metric, "ate_rmse_m");
  EXPECT_EQ(found[0].kind, tools::ChangeKind::worse);
  EXPECT_NEAR(found[0].percent, 20, 8) << "four deviations of a mean of 20 pairs";
  EXPECT_THAT(found[0].note, HasSubstr("geometric means over 20 trials"));
}

TEST(Comparison, AllScenariosTogetherRaiseNoMoreFalseAlarmsThanStated) {
  constexpr std::uint64_t kComparisons = 400;
  constexpr int kMost = 36;  // three and a half standard deviations above a count of 20
  int count = 0;
  for (std::uint64_t i = 0; i < kComparisons; ++i) {
    const std::vector<Change> changes =
        tools::compare_results(several_scenarios(1, 2 * i + 1), several_scenarios(1, 2 * i + 2),
                               {.level = 0.05, .worse_percent = 0, .better_percent = 0});
    count += tools::has_alarm(changes) ? 1 : 0;
  }
  EXPECT_LE(count, kMost);
  EXPECT_GE(count, 1) << "a level of 5 % is used";
}

}  // namespace
