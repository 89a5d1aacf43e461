#include "vo/scale/scale_watch.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/plane_map.h"

namespace {

using support::grey_frame;
using support::small_camera;
using vo::SE3;

/// 1 cm a frame past the plane at 2 m.
SE3 T_world_walker(int frame) {
  return SE3(Eigen::Quaterniond::Identity(), {0.01 * frame, 0.003 * frame, 0});
}

/// A map of its own, observed in the 20 frames after its host, its depths multiplied by a factor.
vo::PastMap past_map(int host, double factor) {
  vo::DepthMap map({});
  map.start(grey_frame(small_camera(), T_world_walker(host)), 2);
  for (int i = 1; i <= 20; ++i) {
    map.observe(grey_frame(small_camera(), T_world_walker(host + i)),
                {T_world_walker(host + i).inverse() * T_world_walker(host)});
    map.regularise();
  }
  map.rescale(factor);
  return {map.host(), map.hypotheses(), T_world_walker(host), {}};
}

TEST(ScaleWatch, MapsOfOneScaleAgree) {
  const auto relative = vo::relative_scale(past_map(0, 1), past_map(10, 1));
  ASSERT_TRUE(relative);
  EXPECT_GT(relative->edges, 500U);
  EXPECT_LT(relative->sigma, 0.005);
  EXPECT_LT(std::abs(relative->log_scale), 3 * relative->sigma);
}

TEST(ScaleWatch, TheLaterMapsScaleIsFound) {
  const vo::PastMap earlier = past_map(0, 1);
  for (const double factor : {0.8, 1.02, 1.5}) {
    const auto relative = vo::relative_scale(earlier, past_map(10, factor));
    ASSERT_TRUE(relative);
    EXPECT_NEAR(relative->log_scale, std::log(factor), 0.005);
  }
}

TEST(ScaleWatch, MapsOfDifferentPlacesSayNothing) {
  vo::PastMap elsewhere = past_map(10, 1);
  elsewhere.T_world_host = SE3(Eigen::Quaterniond::Identity(), {40, 0, 0});
  EXPECT_FALSE(vo::relative_scale(past_map(0, 1), elsewhere));
}

/// The place of the first map is still seen from the third, and tells what the scale has lost.
TEST(ScaleWatch, WhatIsSeenAgainCorrectsTheScale) {
  const double drift = std::log(1.1);
  vo::ScaleWatch watch;
  EXPECT_EQ(watch.add(past_map(0, 1)).sigma, 0);
  const vo::ScaleEstimate second = watch.add(past_map(5, 1.1));
  EXPECT_NEAR(second.drift, drift, 0.005);
  EXPECT_GT(second.sigma, 0);
  EXPECT_EQ(second.correction, 0);
  const vo::ScaleEstimate third = watch.add(past_map(10, 1.1));
  EXPECT_NEAR(third.correction, -drift, 0.01);
  EXPECT_NEAR(third.drift, 0, 1e-12);
}

TEST(ScaleWatch, AStepWithoutCommonEdgesLosesTheScale) {
  vo::ScaleWatch watch;
  watch.add(past_map(0, 1));
  vo::PastMap elsewhere = past_map(10, 1);
  elsewhere.T_world_host = SE3(Eigen::Quaterniond::Identity(), {40, 0, 0});
  EXPECT_GT(watch.add(elsewhere).sigma, 0.4);
  vo::ScaleWatch restarted;
  restarted.lose_scale();
  EXPECT_GT(restarted.scale().sigma, 0.4);
}

}  // namespace
