#include "synth/path/rest_spline.h"

#include <gtest/gtest.h>

namespace synth {
namespace {

using Eigen::Vector2d;

constexpr double kStep = 0.5;  // s

RestSpline<2> zigzag() {
  return {{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 0.5}, {3, 0}}, kStep};
}

TEST(RestSpline, RunsFromItsFirstToItsLastControlPoint) {
  const RestSpline<2> spline = zigzag();
  EXPECT_DOUBLE_EQ(spline.duration(), 3.5);
  EXPECT_LT((spline.at(0) - Vector2d(0, 0)).norm(), 1e-15);
  EXPECT_LT((spline.at(3.5) - Vector2d(3, 0)).norm(), 1e-15);
  EXPECT_EQ(spline.at(-1), spline.at(0));
  EXPECT_EQ(spline.at(9), spline.at(3.5));
}

/// Also where it starts and stops: it rests there.
TEST(RestSpline, ItsSecondDerivativeIsContinuous) {
  const RestSpline<2> spline = zigzag();
  constexpr double kDifference = 1e-4;  // s
  constexpr double kJerk = 40;          // 1/s^3, more than it has anywhere
  const auto second = [&](double time) -> Vector2d {
    return (spline.at(time - kDifference) - 2 * spline.at(time) + spline.at(time + kDifference)) /
           (kDifference * kDifference);
  };
  for (double knot = 0; knot <= 3.5; knot += kStep) {
    const Vector2d jump = second(knot + kDifference) - second(knot - kDifference);
    EXPECT_LT(jump.norm(), kJerk * 2 * kDifference) << "at " << knot << " s";
  }
}

TEST(RestSpline, IsNowhereSteeperThanItsControlPolygon) {
  const RestSpline<2> spline = zigzag();
  constexpr double kSteepest = 1.12 / kStep;  // of the last side
  for (double time = 0; time < 3.5; time += 0.01) {
    EXPECT_LE((spline.at(time + 0.01) - spline.at(time)).norm() / 0.01, kSteepest);
  }
}

TEST(RestSpline, ReproducesAStraightLineBetweenItsEnds) {
  std::vector<Eigen::Matrix<double, 1, 1>> controls;
  for (int i = 0; i < 8; ++i) {
    controls.emplace_back(3.0 * i);
  }
  const RestSpline<1> spline(controls, 1);
  for (const double time : {2.0, 3.3, 5.9, 7.0}) {
    EXPECT_NEAR(spline.at(time)[0], 3 * (time - 1), 1e-12);
  }
}

}  // namespace
}  // namespace synth
