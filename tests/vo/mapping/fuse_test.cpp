#include "vo/mapping/fuse.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/support/plane_map.h"

namespace {

vo::Hypotheses one_hypothesis() {
  const vo::FramePyramid frame = support::grey_frame(support::small_camera(), vo::SE3());
  return vo::edge_hypotheses(frame.levels[0], {}, 0.5F);
}

TEST(Fuse, IsTheProductOfTwoNormalDistributions) {
  vo::Hypotheses hypotheses = one_hypothesis();
  hypotheses.set(0, 0.5F, 0.01F);
  vo::fuse({vo::SearchOutcome::found, 0.56F, 0.02F}, {}, 0, hypotheses);
  EXPECT_NEAR(hypotheses.inverse_depth[0], (0.5 / 0.01 + 0.56 / 0.02) / (1 / 0.01 + 1 / 0.02),
              1e-6);
  EXPECT_NEAR(hypotheses.variance[0], 1 / (1 / 0.01 + 1 / 0.02), 1e-7);
}

TEST(Fuse, AFirstObservationReplacesAGuessUntilItIsConfirmed) {
  vo::Hypotheses hypotheses = one_hypothesis();
  vo::fuse({vo::SearchOutcome::found, 0.8F, 0.02F, 0.1F}, {}, 0, hypotheses);
  EXPECT_EQ(hypotheses.state[0], vo::DepthState::tentative);
  EXPECT_FLOAT_EQ(hypotheses.inverse_depth[0], 0.8F);
  EXPECT_FLOAT_EQ(hypotheses.variance[0], 0.02F + 0.1F * 0.1F);
  EXPECT_FALSE(hypotheses.is_confident(0, 10));
  vo::Hypotheses refuted = hypotheses;
  vo::count_failure({}, 0.3F, 0, refuted);
  EXPECT_EQ(refuted.state[0], vo::DepthState::none);
  vo::fuse({vo::SearchOutcome::found, 0.8F, 0.02F, 0.1F}, {}, 0, hypotheses);
  EXPECT_EQ(hypotheses.state[0], vo::DepthState::known);
  EXPECT_TRUE(hypotheses.is_confident(0, 10));
}

/// Five observations d + k o + noise, o the host's offset: the weighted least-squares solution of
/// all at once, with o of variance 1 around 0 beforehand.
TEST(Fuse, OneByOneIsLeastSquaresOfDepthAndOffset) {
  const std::array<vo::Observation, 5> seen = {
      vo::Observation{vo::SearchOutcome::found, 0.60F, 0.004F, 0.10F},
      {vo::SearchOutcome::found, 0.58F, 0.003F, -0.05F},
      {vo::SearchOutcome::found, 0.55F, 0.002F, 0.04F},
      {vo::SearchOutcome::found, 0.54F, 0.001F, 0.02F},
      {vo::SearchOutcome::found, 0.53F, 0.001F, 0.01F}};
  vo::Hypotheses hypotheses = one_hypothesis();
  Eigen::Matrix2d H = Eigen::Vector2d(0, 1).asDiagonal();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  for (const vo::Observation& observation : seen) {
    vo::fuse(observation, {}, 0, hypotheses);
    const Eigen::Vector2d J(1, observation.offset_slope);
    H += J * J.transpose() / observation.variance;
    b += J * observation.inverse_depth / observation.variance;
  }
  const Eigen::Matrix2d covariance = H.inverse();
  const Eigen::Vector2d solution = covariance * b;
  EXPECT_NEAR(hypotheses.inverse_depth[0], solution.x(), 1e-5);
  EXPECT_NEAR(hypotheses.offset[0], solution.y(), 1e-4);
  EXPECT_NEAR(hypotheses.variance[0], covariance(0, 0), 1e-7);
  EXPECT_NEAR(hypotheses.offset_covariance[0], covariance(0, 1), 1e-6);
  EXPECT_NEAR(hypotheses.offset_variance[0], covariance(1, 1), 1e-5);
}

/// A camera that stands still after a step sees the host's error again and again.
TEST(Fuse, WhatIsAlikeInAllFramesDoesNotAverageAway) {
  vo::Hypotheses hypotheses = one_hypothesis();
  for (int frame = 0; frame < 1000; ++frame) {
    vo::fuse({vo::SearchOutcome::found, 0.8F, 0.001F, 0.05F}, {}, 0, hypotheses);
  }
  EXPECT_NEAR(hypotheses.variance[0], 0.05 * 0.05 + 0.001 / 1000, 1e-5);
}

TEST(Fuse, ThreeNetFailuresForget) {
  vo::Hypotheses hypotheses = one_hypothesis();
  hypotheses.set(0, 0.8F, 0.001F);
  vo::fuse({vo::SearchOutcome::found, 0.8F, 0.001F}, {}, 0, hypotheses);
  for (int failures = 0; failures < 3; ++failures) {
    vo::count_failure({}, 0.3F, 0, hypotheses);
    EXPECT_EQ(hypotheses.state[0], vo::DepthState::known);
  }
  vo::count_failure({}, 0.3F, 0, hypotheses);
  EXPECT_EQ(hypotheses.state[0], vo::DepthState::none);
  EXPECT_FLOAT_EQ(hypotheses.inverse_depth[0], 0.3F);
}

/// The moments of the true posterior p(z, share | x), summed over a grid.
TEST(BetaFilter, HasTheMomentsOfTheTruePosterior) {
  const vo::BetaFilter prior{.mean = 0.5, .variance = 0.01, .a = 6, .b = 4};
  const double x = 0.62;
  const double tau2 = 0.004;
  const double range = 2;
  double sum = 0;
  double z1 = 0;
  double z2 = 0;
  double share1 = 0;
  double share2 = 0;
  for (int i = 0; i <= 400; ++i) {
    const double z = -0.5 + 2.0 * i / 400;
    for (int j = 1; j < 400; ++j) {
      const double share = j / 400.0;
      const auto normal = [](double value, double mean, double variance) {
        return std::exp(-0.5 * (value - mean) * (value - mean) / variance) /
               std::sqrt(2 * std::numbers::pi * variance);
      };
      const double p = (share * normal(x, z, tau2) + (1 - share) / range) *
                       normal(z, prior.mean, prior.variance) * std::pow(share, prior.a - 1) *
                       std::pow(1 - share, prior.b - 1);
      sum += p;
      z1 += p * z;
      z2 += p * z * z;
      share1 += p * share;
      share2 += p * share * share;
    }
  }
  const vo::BetaFilter posterior = vo::updated(prior, x, tau2, range);
  EXPECT_NEAR(posterior.mean, z1 / sum, 1e-5);
  EXPECT_NEAR(posterior.variance, z2 / sum - std::pow(z1 / sum, 2), 1e-5);
  const double a = posterior.a;
  const double b = posterior.b;
  EXPECT_NEAR(a / (a + b), share1 / sum, 1e-4);
  EXPECT_NEAR(a * (a + 1) / ((a + b) * (a + b + 1)), share2 / sum, 1e-4);
}

}  // namespace
