#include "tools/statistics/significance.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace {

TEST(Significance, StudentsDistributionHasItsClosedForms) {
  for (const double t : {-30.0, -2.0, -0.5, 0.0, 0.1, 1.0, 7.0}) {
    EXPECT_NEAR(tools::student_two_sided(t, 1), 1 - 2 * std::atan(std::abs(t)) / std::numbers::pi,
                1e-13)
        << t;
    EXPECT_NEAR(tools::student_two_sided(t, 2), 1 - std::abs(t) / std::sqrt(2 + t * t), 1e-13) << t;
  }
}

TEST(Significance, StudentsDistributionHasItsDensity) {
  for (const double freedom : {3.0, 9.0, 40.0}) {
    for (const double t : {0.2, 1.5, 4.0}) {
      const double density = std::exp(std::lgamma((freedom + 1) / 2) - std::lgamma(freedom / 2)) /
                             std::sqrt(freedom * std::numbers::pi) *
                             std::pow(1 + t * t / freedom, -(freedom + 1) / 2);
      constexpr double kStep = 1e-4;
      const double slope = (tools::student_two_sided(t + kStep, freedom) -
                            tools::student_two_sided(t - kStep, freedom)) /
                           (2 * kStep);
      EXPECT_NEAR(slope, -2 * density, 1e-7) << freedom << " " << t;
    }
  }
}

TEST(Significance, StudentsQuantileUndoesTheDistribution) {
  for (const double probability : {0.5, 0.7, 0.975, 0.9999}) {
    EXPECT_NEAR(tools::student_two_sided(tools::student_quantile(probability, 4), 4),
                2 * (1 - probability), 1e-12);
  }
  EXPECT_NEAR(tools::student_quantile(0.025, 4), -2.776445, 1e-6) << "printed tables";
}

TEST(Significance, AMeanHasTheIntervalOfItsSample) {
  const tools::Estimate estimate = tools::estimate_mean(std::vector<double>{1, 2, 3});
  EXPECT_DOUBLE_EQ(estimate.mean, 2);
  EXPECT_NEAR(estimate.high - 2, 4.302653 / std::sqrt(3), 1e-6) << "t of 2 degrees, sigma 1";
  EXPECT_NEAR(estimate.high + estimate.low, 4, 1e-12);
  EXPECT_EQ(tools::estimate_mean(std::vector<double>{5}).low, 5) << "one value has no spread";
  EXPECT_TRUE(std::isnan(tools::estimate_mean(std::vector<double>{1, std::nan("")}).mean));
  EXPECT_TRUE(std::isnan(tools::estimate_mean({}).mean));
}

TEST(Significance, PairedValuesAreComparedByTheirDifferences) {
  const std::vector<double> before{10, 20, 30};
  EXPECT_NEAR(tools::paired_p_value(before, std::vector<double>{11, 22, 33}),
              tools::student_two_sided(2 * std::sqrt(3.0), 2), 1e-12);
  EXPECT_EQ(tools::paired_p_value(before, before), 1);
}

TEST(Significance, ASpreadIsTakenForNoLessThanTheLeastDeviation) {
  const std::vector<double> before{10, 20, 30};
  const std::vector<double> after{11, 21, 31};
  EXPECT_NEAR(tools::paired_p_value(before, after, 0.5),
              tools::student_two_sided(2 * std::sqrt(3.0), 2), 1e-12);
  EXPECT_EQ(tools::paired_p_value(before, after), 0) << "the limit of ever smaller spreads";
  EXPECT_NEAR(tools::welch_p_value(std::vector<double>{1, 1, 1}, std::vector<double>{3, 3, 3}, 1),
              tools::student_two_sided(2 / std::sqrt(2.0 / 3), 4), 1e-12);
}

TEST(Significance, IndependentSamplesOfEqualSizeAndVarianceHaveThePooledTest) {
  const std::vector<double> before{1, 2, 3};
  const std::vector<double> after{3, 4, 5};
  EXPECT_NEAR(tools::welch_p_value(before, after),
              tools::student_two_sided(2 / std::sqrt(2.0 / 3), 4), 1e-12);
}

TEST(Significance, FishersTestCountsTheTablesThatAreNoLikelier) {
  EXPECT_NEAR(tools::fisher_p_value({3, 4}, {1, 4}), 34.0 / 70, 1e-12) << "the lady tasting tea";
  EXPECT_NEAR(tools::fisher_p_value({4, 4}, {0, 4}), 2.0 / 70, 1e-12);
  EXPECT_NEAR(tools::fisher_p_value({5, 5}, {4, 5}), 1, 1e-12);
  EXPECT_NEAR(tools::fisher_p_value({1, 10}, {11, 14}), 0.0027594562, 1e-9) << "printed examples";
}

TEST(Significance, HolmRejectsStepByStep) {
  const std::vector<double> p_values{0.012, 0.5, 0.001, 0.02};
  EXPECT_EQ(tools::holm_rejections(p_values, 0.05), (std::vector<bool>{true, false, true, true}))
      << "0.001 <= 0.05 / 4, 0.012 <= 0.05 / 3, 0.02 <= 0.05 / 2, 0.5 > 0.05";
  EXPECT_EQ(tools::holm_rejections(p_values, 0.03), (std::vector<bool>{false, false, true, false}))
      << "0.012 > 0.03 / 3 stops it";
}

}  // namespace
