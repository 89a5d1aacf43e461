#include "synth/scene/animation.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace synth {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr double kRounding = 1e-6;  // the keys are floats

AnimationCurve line(Interpolation interpolation) {
  return {.interpolation = interpolation, .width = 2, .times = {1, 3}, .values = {0, 10, 4, 20}};
}

TEST(Animation, ALineGoesEvenlyFromKeyToKey) {
  EXPECT_THAT(value_at(line(Interpolation::linear), 1.5), ElementsAre(1, 12.5));
}

TEST(Animation, AStepKeepsTheKeyBefore) {
  EXPECT_THAT(value_at(line(Interpolation::step), 2.999), ElementsAre(0, 10));
  EXPECT_THAT(value_at(line(Interpolation::step), 3), ElementsAre(4, 20));
}

TEST(Animation, NothingMovesBeforeTheFirstAndAfterTheLastKey) {
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear}) {
    EXPECT_THAT(value_at(line(interpolation), -7), ElementsAre(0, 10));
    EXPECT_THAT(value_at(line(interpolation), 99), ElementsAre(4, 20));
  }
}

/// A cubic through its own values and derivatives is found again exactly.
TEST(Animation, ASplineOfACubicIsTheCubic) {
  const auto cubic = [](double t) { return 2 * t * t * t - 3 * t * t + t - 5; };
  const auto derivative = [](double t) { return 6 * t * t - 6 * t + 1; };
  AnimationCurve curve{.interpolation = Interpolation::cubic_spline, .times = {0.5F, 1, 3}};
  for (const float t : curve.times) {
    for (const double part : {derivative(t), cubic(t), derivative(t)}) {
      curve.values.push_back(static_cast<float>(part));
    }
  }
  for (double t = 0.5; t <= 3; t += 0.125) {
    EXPECT_THAT(value_at(curve, t), ElementsAre(DoubleNear(cubic(t), kRounding))) << t;
  }
}

AnimationCurve turn(const std::vector<double>& angles_about_z, float sign_of_the_last) {
  AnimationCurve curve{.width = 4, .holds_quaternions = true};
  for (std::size_t i = 0; i < angles_about_z.size(); ++i) {
    const float sign = i + 1 == angles_about_z.size() ? sign_of_the_last : 1;
    curve.times.push_back(static_cast<float>(i));
    for (const double part :
         {0.0, 0.0, std::sin(angles_about_z[i] / 2), std::cos(angles_about_z[i] / 2)}) {
      curve.values.push_back(sign * static_cast<float>(part));
    }
  }
  return curve;
}

double angle_about_z(const AnimationCurve& curve, double time) {
  const std::vector<double> q = value_at(curve, time);
  return 2 * std::atan2(q[2], q[3]);
}

TEST(Animation, RotationsTurnAtAnEvenRate) {
  const AnimationCurve curve = turn({0.2, 1.4}, 1);
  for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(angle_about_z(curve, share), 0.2 + 1.2 * share, kRounding);
  }
}

TEST(Animation, RotationsTakeTheShorterArcWhateverTheirSign) {
  const double angle = angle_about_z(turn({0, 1}, -1), 0.5);
  EXPECT_NEAR(std::remainder(angle, 2 * std::numbers::pi), 0.5, kRounding);
}

TEST(Animation, ACurveOfOneKeyIsConstant) {
  const AnimationCurve curve{.width = 3, .times = {2}, .values = {1, 2, 3}};
  EXPECT_THAT(value_at(curve, 0), ElementsAre(1, 2, 3));
  EXPECT_TRUE(is_constant(curve));
  EXPECT_FALSE(is_constant(line(Interpolation::linear)));
}

TEST(Animation, ASplineWithTangentsIsNotConstant) {
  AnimationCurve curve{
      .interpolation = Interpolation::cubic_spline, .times = {0, 1}, .values = {0, 5, 0, 0, 5, 0}};
  EXPECT_TRUE(is_constant(curve));
  curve.values[2] = 1;
  EXPECT_FALSE(is_constant(curve));
}

}  // namespace
}  // namespace synth
