#include "vo/residuals/frame_velocity.h"

#include <gtest/gtest.h>

namespace {

using vo::MeanVelocity;
using vo::Vector6d;

/// x(t) = v t + a t^2 / 2, seen at -0.05, 0 and 0.03 s.
TEST(FrameVelocity, IsExactUnderSteadyAcceleration) {
  const Vector6d v = (Vector6d() << 0.3, -0.1, 0.2, 0.4, 0.1, -0.5).finished();
  const Vector6d a = (Vector6d() << -2, 1, 3, 5, -4, 2).finished();
  const auto x = [&](double t) -> Vector6d { return v * t + a * t * t / 2; };
  const MeanVelocity before{(x(0) - x(-0.05)) / 0.05, 0.05};
  const MeanVelocity last{(x(0.03) - x(0)) / 0.03, 0.03};
  const vo::FrameVelocity at_end = vo::velocity_at_end(last, before);
  EXPECT_LT((at_end.twist - (v + 0.03 * a)).norm(), 1e-12);
  EXPECT_LT((at_end.doubt - (at_end.twist - last.twist)).norm(), 1e-12);
}

TEST(FrameVelocity, IsTheMeanWhereNothingIsKnownOfBefore) {
  const MeanVelocity last{Vector6d::Constant(0.2), 0.03};
  const vo::FrameVelocity at_end = vo::velocity_at_end(last, {});
  EXPECT_EQ(at_end.twist, last.twist);
  EXPECT_EQ(at_end.doubt, Vector6d::Zero());
}

}  // namespace
