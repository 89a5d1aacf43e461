#include "tools/statistics/difference_test.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <vector>

#include <gtest/gtest.h>

#include "tools/statistics/significance.h"
#include "vo/core/random.h"

namespace {

using tools::Samples;

TEST(DifferenceTest, ASinglePairIsOneRunOfADeterministicProgram) {
  EXPECT_EQ(tools::test_difference({{0.1}, {0.11}}, {}).p_value, 0);
  EXPECT_EQ(tools::test_difference({{0.1}, {0.1}}, {}).p_value, 1);
  EXPECT_EQ(tools::test_difference({{0.1}, {0.2}, false}, {}).p_value, 1) << "of other seeds";
}

TEST(DifferenceTest, ContinuousValuesAreComparedByTheirLogarithms) {
  const Samples samples{{1, 10, 100}, {2, 40, 200}};
  const std::vector<double> zero(3, 0.0);
  EXPECT_NEAR(tools::test_difference(samples, {}).p_value,
              tools::paired_p_value(zero, std::vector<double>{1, 2, 1}), 1e-12);
}

TEST(DifferenceTest, ZeroSpreadIsNotCertainty) {
  EXPECT_EQ(tools::test_difference({{5, 7}, {6, 8}}, {.step = 1}).p_value, 0.5) << "keyframes";
  EXPECT_NEAR(tools::test_difference({{5, 5}, {6, 6}, false}, {.step = 1}).p_value, 1.0 / 3, 1e-12);
  EXPECT_EQ(tools::test_difference({{0, 0, 0}, {1, 1, 1}}, {}).p_value, 0.25) << "equal values";
  const double scaled =
      tools::test_difference({{0.010, 0.012}, {0.050, 0.060}}, {.negligible = 5e-5}).p_value;
  EXPECT_GT(scaled, 1e-4);
  EXPECT_LT(scaled, 5e-3);
}

TEST(DifferenceTest, SaysWhenSamplesAreTooSmallToTell) {
  EXPECT_EQ(tools::test_difference({{5, 5}, {6, 7}}, {.step = 1}).least_p_value, 0.5);
  EXPECT_NEAR(tools::test_difference({{5, 5, 5}, {5, 6, 7}, false}, {.step = 1}).least_p_value, 0.1,
              1e-12);
  EXPECT_EQ(tools::test_difference({{5, 6}, {8, 7}}, {}).least_p_value, 0);
}

/// A quantity whose values vary from seed to seed, without any change.
struct Quantity {
  const char* name;
  tools::Resolution resolution;
  std::function<double(vo::Random&)> draw;
};

std::vector<Quantity> quantities() {
  const auto keyframes = [](vo::Random& random) { return 5.0 + random.below(3); };
  const auto rare = [](vo::Random& random) { return random.uniform() < 0.1 ? 6.0 : 5.0; };
  const auto tracked = [](vo::Random& random) {
    return random.uniform() < 0.6 ? 1.0 : (150 + random.below(30)) / 180.0;
  };
  const auto error = [](vo::Random& random) { return 0.005 * std::exp(0.3 * random.normal()); };
  const auto heavy = [](vo::Random& random) {  // of Student's distribution with 3 degrees
    const double a = random.normal();
    const double b = random.normal();
    const double c = random.normal();
    return 0.005 * std::exp(0.2 * random.normal() / std::sqrt((a * a + b * b + c * c) / 3));
  };
  const auto rounded = [=](vo::Random& random) { return std::round(error(random) * 1e3) / 1e3; };
  return {{"keyframes", {.step = 1, .negligible = 1}, keyframes},
          {"one more keyframe now and then", {.step = 1, .negligible = 1}, rare},
          {"tracked_fraction", {.step = 1.0 / 180, .negligible = 0.005}, tracked},
          {"ate", {.negligible = 5e-5}, error},
          {"ate with outliers", {.negligible = 5e-5}, heavy},
          {"ate in whole millimetres", {.negligible = 5e-5}, rounded}};
}

std::vector<double> drawn(const Quantity& quantity, int seeds, vo::Random& random) {
  std::vector<double> values;
  for (int i = 0; i < seeds; ++i) {
    values.push_back(quantity.draw(random));
  }
  return values;
}

/// Returns how many of the tests without a change have a p-value of the level or less.
int count_significant(const Quantity& quantity, int seeds, bool paired, int tests, double level) {
  vo::Random random(static_cast<std::uint64_t>(seeds), paired ? 1 : 2);
  int count = 0;
  for (int i = 0; i < tests; ++i) {
    const Samples samples{drawn(quantity, seeds, random), drawn(quantity, seeds, random), paired};
    count += tools::test_difference(samples, quantity.resolution).p_value <= level ? 1 : 0;
  }
  return count;
}

TEST(DifferenceTest, NoChangeIsSignificantNoMoreOftenThanTheLevelSays) {
  constexpr double kLevel = 0.01;
  std::cout << "share of significant tests in %, same seeds / other seeds, of 2, 3, 5, 12 seeds\n";
  for (const Quantity& quantity : quantities()) {
    std::cout << quantity.name;
    for (const int seeds : {2, 3, 5, 12}) {
      for (const bool paired : {true, false}) {
        const int tests = seeds == 12 && !paired ? 1500 : 4000;
        const int count = count_significant(quantity, seeds, paired, tests, kLevel);
        const double expected = kLevel * tests;
        EXPECT_LE(count, expected + 3 * std::sqrt(expected))
            << quantity.name << ", " << seeds << (paired ? " paired" : " independent");
        std::cout << (paired ? " | " : " / ") << 100.0 * count / tests;
      }
    }
    std::cout << "\n";
  }
}

}  // namespace
