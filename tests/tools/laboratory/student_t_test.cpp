#include "tools/laboratory/student_t.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace {

TEST(StudentT, HasTheClosedFormsOfOneAndTwoDegreesOfFreedom) {
  for (const double t : {-30.0, -2.0, -0.5, 0.0, 0.1, 1.0, 7.0}) {
    EXPECT_NEAR(tools::student_cdf(t, 1), 0.5 + std::atan(t) / std::numbers::pi, 1e-13) << t;
    EXPECT_NEAR(tools::student_cdf(t, 2), 0.5 + t / (2 * std::sqrt(2 + t * t)), 1e-13) << t;
  }
}

TEST(StudentT, HasTheDensityOfStudentsDistribution) {
  for (const double freedom : {3.0, 9.0, 40.0}) {
    for (const double t : {-3.0, 0.2, 1.5, 4.0}) {
      const double density = std::exp(std::lgamma((freedom + 1) / 2) - std::lgamma(freedom / 2)) /
                             std::sqrt(freedom * std::numbers::pi) *
                             std::pow(1 + t * t / freedom, -(freedom + 1) / 2);
      constexpr double kStep = 1e-4;
      const double slope =
          (tools::student_cdf(t + kStep, freedom) - tools::student_cdf(t - kStep, freedom)) /
          (2 * kStep);
      EXPECT_NEAR(slope, density, 1e-7) << freedom << " " << t;
    }
  }
}

TEST(StudentT, TheQuantileUndoesTheDistribution) {
  for (const double probability : {0.001, 0.3, 0.5, 0.975, 0.9999}) {
    EXPECT_NEAR(tools::student_cdf(tools::student_quantile(probability, 4), 4), probability, 1e-12);
  }
  EXPECT_NEAR(tools::student_quantile(0.975, 4), 2.776445, 1e-6) << "printed tables";
}

TEST(StudentT, AMeanHasTheIntervalOfItsSample) {
  const tools::Estimate estimate = tools::estimate_mean(std::vector<double>{1, 2, 3});
  EXPECT_DOUBLE_EQ(estimate.mean, 2);
  EXPECT_NEAR(estimate.high - 2, 4.302653 / std::sqrt(3), 1e-6) << "t of 2 degrees, sigma 1";
  EXPECT_NEAR(estimate.high + estimate.low, 4, 1e-12);
  EXPECT_EQ(tools::estimate_mean(std::vector<double>{5}).low, 5) << "one value has no spread";
  EXPECT_TRUE(std::isnan(tools::estimate_mean(std::vector<double>{1, std::nan("")}).mean));
  EXPECT_TRUE(std::isnan(tools::estimate_mean({}).mean));
}

TEST(StudentT, PairedValuesAreComparedByTheirDifferences) {
  const std::vector<double> before{10, 20, 30};
  EXPECT_NEAR(tools::paired_p_value(before, std::vector<double>{11, 22, 33}),
              tools::student_two_sided(2 * std::sqrt(3.0), 2), 1e-12);
  EXPECT_EQ(tools::paired_p_value(before, before), 1);
  EXPECT_EQ(tools::paired_p_value(before, std::vector<double>{11, 21, 31}), 0)
      << "no chance is seen";
  EXPECT_EQ(tools::paired_p_value(std::vector<double>{1}, std::vector<double>{2}), 0);
}

TEST(StudentT, IndependentSamplesOfEqualSizeAndVarianceHaveThePooledTest) {
  const std::vector<double> before{1, 2, 3};
  const std::vector<double> after{3, 4, 5};
  EXPECT_NEAR(tools::welch_p_value(before, after),
              tools::student_two_sided(2 / std::sqrt(2.0 / 3), 4), 1e-12);
}

TEST(StudentT, FishersTestCountsTheTablesThatAreNoLikelier) {
  EXPECT_NEAR(tools::fisher_p_value({3, 4}, {1, 4}), 34.0 / 70, 1e-12) << "the lady tasting tea";
  EXPECT_NEAR(tools::fisher_p_value({4, 4}, {0, 4}), 2.0 / 70, 1e-12);
  EXPECT_NEAR(tools::fisher_p_value({5, 5}, {4, 5}), 1, 1e-12);
  EXPECT_NEAR(tools::fisher_p_value({1, 10}, {11, 14}), 0.0027594562, 1e-9) << "printed examples";
}

TEST(StudentT, HolmRejectsStepByStep) {
  const std::vector<double> p_values{0.012, 0.5, 0.001, 0.02};
  EXPECT_EQ(tools::holm_rejections(p_values, 0.05), (std::vector<bool>{true, false, true, true}))
      << "0.001 <= 0.05 / 4, 0.012 <= 0.05 / 3, 0.02 <= 0.05 / 2, 0.5 > 0.05";
  EXPECT_EQ(tools::holm_rejections(p_values, 0.03), (std::vector<bool>{false, false, true, false}))
      << "0.012 > 0.03 / 3 stops it";
}

}  // namespace
