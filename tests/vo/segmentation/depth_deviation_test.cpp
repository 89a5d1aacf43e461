#include "vo/segmentation/depth_deviation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"

namespace {

using support::plane_frame;
using support::small_camera;
using support::sway;
using vo::SE3;

constexpr vo::DepthNoise kExact{.constant = 1e-9};

/// The plane's depth from a pose, times a factor.
vo::PyramidLevel level_at(const SE3& T_world_camera, float factor = 1) {
  vo::RgbdFrame frame = plane_frame(small_camera(), T_world_camera, 0);
  frame.depth = frame.depth * factor;
  return vo::build_pyramid(frame, small_camera(), {}).levels.front();
}

double deviation(const vo::PyramidLevel& current, const SE3& T_cur_ref,
                 const vo::DepthNoise& noise = kExact, const vo::TileMask& moving = {}) {
  return vo::depth_deviation({level_at(SE3()), current, T_cur_ref}, noise, moving);
}

TEST(DepthDeviation, OfARigidWorldIsThatOfTheNearestPixel) {
  EXPECT_LT(deviation(level_at(SE3()), SE3()), 1e-6);
  const SE3 T_world_current = sway(5);
  EXPECT_LT(deviation(level_at(T_world_current), T_world_current.inverse()), 1e-3);
}

TEST(DepthDeviation, OfDepthsInAnotherScaleIsTheDifferenceOfTheScales) {
  EXPECT_NEAR(deviation(level_at(SE3(), 1.05F), SE3()), 0.05, 1e-5);
  EXPECT_NEAR(deviation(level_at(SE3(), 0.96F), SE3()), 0.04, 1e-5);
}

TEST(DepthDeviation, LeavesOutTheNoiseOfBothMeasurements) {
  const vo::DepthNoise noise{.linear = 0.01};
  EXPECT_NEAR(deviation(level_at(SE3(), 1.05F), SE3(), noise), 0.05 - 0.01 * std::sqrt(2), 1e-5);
  EXPECT_EQ(deviation(level_at(SE3(), 1.01F), SE3(), noise), 0);
}

TEST(DepthDeviation, IsAtMostATenthWhereTheOtherFrameSeesThroughASurface) {
  EXPECT_NEAR(deviation(level_at(SE3(), 1.5F), SE3()), 0.1, 1e-6);
}

TEST(DepthDeviation, LeavesOutWhatIsHiddenAndWhatMoves) {
  EXPECT_EQ(deviation(level_at(SE3(), 0.8F), SE3()), 0);
  EXPECT_EQ(deviation(level_at(SE3(), 1.05F), SE3(), kExact, vo::TileMask().set()), 0);
}

}  // namespace
