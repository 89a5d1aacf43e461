#include "vo/residuals/robust.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using vo::robust_value;
using vo::RobustLoss;

constexpr float kScale = 0.02F;

/// w(r) = rho'(r) / (2 r), by central differences.
TEST(Robust, WeightIsTheDerivativeOfTheLoss) {
  constexpr float kStep = 1e-4F;
  for (const RobustLoss loss : {RobustLoss::none, RobustLoss::huber, RobustLoss::student_t}) {
    for (const float r : {-0.3F, -0.03F, -0.01F, 0.005F, 0.05F, 0.4F}) {
      const float slope = (robust_value(loss, r + kStep, kScale).loss -
                           robust_value(loss, r - kStep, kScale).loss) /
                          (2 * kStep);
      EXPECT_NEAR(robust_value(loss, r, kScale).weight, slope / (2 * r), 2e-3) << r;
    }
  }
}

/// d(w r) / dr = share w, by central differences.
TEST(Robust, CurvatureShareIsTheDerivativeOfTheInfluence) {
  constexpr float kStep = 1e-4F;
  for (const RobustLoss loss :
       {RobustLoss::none, RobustLoss::huber, RobustLoss::tukey, RobustLoss::student_t}) {
    for (const float r : {-0.3F, -0.03F, -0.01F, 0.005F, 0.05F, 0.4F}) {
      const auto influence = [&](float x) { return robust_value(loss, x, kScale).weight * x; };
      const float slope = (influence(r + kStep) - influence(r - kStep)) / (2 * kStep);
      const double share = vo::curvature_share(loss, r, kScale);
      EXPECT_NEAR(share * robust_value(loss, r, kScale).weight, slope, 2e-3) << r;
    }
  }
}

TEST(Robust, HuberIsContinuousAtItsScale) {
  const auto inside = robust_value(RobustLoss::huber, kScale, kScale);
  const auto outside = robust_value(RobustLoss::huber, kScale * 1.0001F, kScale);
  EXPECT_NEAR(inside.loss, outside.loss, 1e-6);
  EXPECT_NEAR(inside.weight, outside.weight, 1e-3);
}

}  // namespace
