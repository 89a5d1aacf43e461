#include "tools/statistics/power.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace {

constexpr double kPower = 0.9;
constexpr int kDraws = 2000;

TEST(Power, OfManyPairsIsThatOfTheNormalDistribution) {
  // With 400 pairs Student's distribution is nearly normal: the change found in 90 % is
  // (z(0.995) + z(0.9)) standard errors, 2.576 + 1.282.
  const tools::ComparisonDesign design{
      .seeds = 400, .deviation = 0.5, .pair_deviation = 0.5, .least_factor = 1};
  EXPECT_NEAR(std::log(tools::detectable_factor(design, kPower, 500)), 3.858 * 0.5 / 20, 0.005);
}

TEST(Power, IndependentSamplesNeedAChangeThatIsGreaterByTheRootOfTwo) {
  tools::ComparisonDesign design{
      .seeds = 100, .deviation = 0.5, .pair_deviation = 0.5, .least_factor = 1};
  const double paired = std::log(tools::detectable_factor(design, kPower, 500));
  design.paired = false;
  EXPECT_NEAR(std::log(tools::detectable_factor(design, kPower, 500)), std::numbers::sqrt2 * paired,
              0.02);
}

TEST(Power, MoreSeedsFindSmallerChanges) {
  double last = HUGE_VAL;
  for (const int seeds : {2, 3, 5, 12}) {
    const double factor = tools::detectable_factor(
        {.seeds = seeds, .deviation = 0.2, .pair_deviation = 0.05}, kPower, kDraws);
    EXPECT_LT(factor, last) << seeds;
    last = factor;
  }
  EXPECT_GT(last, 1.1) << "smaller changes are never alarms";
}

TEST(Power, WhatNoFactorShowsIsInfinite) {
  EXPECT_TRUE(std::isinf(tools::detectable_factor(
      {.seeds = 2, .deviation = 0.2, .pair_deviation = 0.3, .level = 1e-5}, kPower, 100)));
}

}  // namespace
