#include "synth/truth/imu.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/example_trajectory.h"

namespace synth {
namespace {

constexpr double kGravity = 9.81;

/// Of `example_pose`, s.
const TimeSpan kSpan{0.5, 2.5};

TEST(Imu, OnACircularOrbitReadsTheCentripetalForceGravityAndTheTurn) {
  constexpr double kRadius = 2;  // m
  constexpr double kPeriod = 4;  // s
  const double turn = 2 * std::numbers::pi / kPeriod;
  const CameraPath path = orbit({.radius = kRadius, .height = 0, .period = kPeriod});
  const vo::ImuRecord record = measure_imu(path, {0, 1}, {.noise = {.rate = 50}});
  ASSERT_EQ(record.samples.size(), 51U);
  for (const vo::ImuSample& sample : record.samples) {
    // The camera looks at the centre, upright: its z is inwards, its y is down.
    const Eigen::Vector3d force(0, -kGravity, kRadius * turn * turn);
    EXPECT_LT((sample.specific_force - force).norm(), 2e-5) << "m/s^2 at " << sample.timestamp;
    EXPECT_LT((sample.angular_velocity - Eigen::Vector3d(0, -turn, 0)).norm(), 1e-6) << "rad/s";
  }
  EXPECT_NEAR(record.states[10].velocity.norm(), kRadius * turn, 1e-5) << "m/s";
}

TEST(Imu, AtRestReadsGravityUpwards) {
  const vo::SE3 upright = vo::look_at({0, 0, 0}, {0, 0, -1}, Eigen::Vector3d::UnitY());
  const vo::ImuRecord record = measure_imu([&](double) { return upright; }, {0, 0.1}, {});
  for (const vo::ImuSample& sample : record.samples) {
    EXPECT_LT((sample.specific_force - Eigen::Vector3d(0, -kGravity, 0)).norm(), 1e-12);
    EXPECT_LT(sample.angular_velocity.norm(), 1e-12);
  }
}

TEST(Imu, IntegratedTwiceReturnsToThePath) {
  const CameraPath path = support::example_pose;
  const ImuOptions options{.noise = {.rate = 1000}};
  const vo::ImuRecord record = measure_imu(path, kSpan, options);
  const double dt = 1 / options.noise.rate;
  Eigen::Quaterniond R = path(kSpan.begin).rotation();
  Eigen::Vector3d p = path(kSpan.begin).translation();
  Eigen::Vector3d v = record.states.front().velocity;
  for (std::size_t i = 1; i < record.samples.size(); ++i) {
    const vo::ImuSample& a = record.samples[i - 1];
    const vo::ImuSample& b = record.samples[i];
    vo::Vector6d turn = vo::Vector6d::Zero();
    turn.tail<3>() = dt / 2 * (a.angular_velocity + b.angular_velocity);
    const Eigen::Quaterniond next = (R * vo::SE3::exp(turn).rotation()).normalized();
    const Eigen::Vector3d gravity(0, -kGravity, 0);
    const Eigen::Vector3d acceleration =
        (R * a.specific_force + next * b.specific_force) / 2 + gravity;
    p += dt * v + dt * dt / 2 * acceleration;
    v += dt * acceleration;
    R = next;
  }
  EXPECT_LT((p - path(kSpan.end).translation()).norm(), 2e-5) << "m after 2 s";
  EXPECT_LT(R.angularDistance(path(kSpan.end).rotation()), 1e-5) << "rad after 2 s";
  EXPECT_LT((v - record.states.back().velocity).norm(), 2e-5) << "m/s after 2 s";
}

TEST(Imu, NoiseHasTheDensityThatWasAskedFor) {
  const vo::SE3 upright = vo::look_at({0, 0, 0}, {0, 0, -1}, Eigen::Vector3d::UnitY());
  const CameraPath path = [&](double) { return upright; };
  const ImuOptions options{.noise = {.rate = 100, .gyro_noise = 0.01, .accel_noise = 0.02}};
  const vo::ImuRecord perfect = measure_imu(path, {0, 100}, {.noise = {.rate = 100}});
  const vo::ImuRecord noisy = measure_imu(path, {0, 100}, options);
  Eigen::Vector3d gyro = Eigen::Vector3d::Zero();
  Eigen::Vector3d accel = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < noisy.samples.size(); ++i) {
    gyro += (noisy.samples[i].angular_velocity - perfect.samples[i].angular_velocity).cwiseAbs2();
    accel += (noisy.samples[i].specific_force - perfect.samples[i].specific_force).cwiseAbs2();
  }
  const auto count = static_cast<double>(noisy.samples.size());
  for (int axis = 0; axis < 3; ++axis) {  // sigma of 10001 samples is known to 0.7 %
    EXPECT_NEAR(std::sqrt(gyro[axis] / count), 0.01 * 10, 0.03 * 0.1);
    EXPECT_NEAR(std::sqrt(accel[axis] / count), 0.02 * 10, 0.03 * 0.2);
  }
}

TEST(Imu, BiasesWalkAndAreInTheTruth) {
  const vo::SE3 upright = vo::look_at({0, 0, 0}, {0, 0, -1}, Eigen::Vector3d::UnitY());
  const CameraPath path = [&](double) { return upright; };
  const vo::ImuRecord perfect = measure_imu(path, {0, 10}, {});
  const vo::ImuRecord biased = measure_imu(
      path, {0, 10}, {.noise = {.rate = 200, .gyro_bias_walk = 0.1, .accel_bias_walk = 0.2}});
  double step = 0;
  for (std::size_t i = 0; i < biased.samples.size(); ++i) {
    const Eigen::Vector3d bias =
        biased.samples[i].specific_force - perfect.samples[i].specific_force;
    EXPECT_LT((bias - biased.states[i].accel_bias).norm(), 1e-12);
    if (i > 0) {
      step += (biased.states[i].gyro_bias - biased.states[i - 1].gyro_bias).squaredNorm();
    }
  }
  EXPECT_NEAR(std::sqrt(step / 3 / 2000), 0.1 / std::sqrt(200), 0.03 * 0.1 / std::sqrt(200));
}

/// A body that rests until 0 s, moves with constant acceleration and stops at 1 s, as paths through
/// poses do: what is measured of its motion is what is measured without the rest around it.
TEST(Imu, CoversTimesAroundAPathInTheSameSteps) {
  const CameraPath path = [](double time) {
    const double t = std::clamp(time, 0.0, 1.0);
    return vo::SE3(Eigen::Quaterniond::Identity(), {0.5 * t + t * t, 0, 0});
  };
  const ImuOptions options{.noise = {.rate = 200}};
  const vo::ImuRecord alone = measure_imu(path, {0, 1}, options);
  const vo::ImuRecord covering = measure_imu(path, {0, 1}, options, {-0.021, 1.003});
  ASSERT_EQ(covering.samples.size(), alone.samples.size() + 5 + 1);
  EXPECT_EQ(covering.samples.front().timestamp, -5 / 200.0);
  EXPECT_EQ(covering.samples.back().timestamp, 201 / 200.0);
  for (std::size_t i = 0; i < alone.samples.size(); ++i) {
    EXPECT_EQ(covering.samples[i + 5].timestamp, alone.samples[i].timestamp);
    EXPECT_EQ(covering.samples[i + 5].specific_force, alone.samples[i].specific_force);
    EXPECT_EQ(covering.states[i + 5].velocity, alone.states[i].velocity);
  }
  for (const std::size_t resting : {0, 1, 2, 3, 4, 206}) {
    EXPECT_LT((covering.samples[resting].specific_force - Eigen::Vector3d(0, 9.81, 0)).norm(), 1e-9)
        << resting;
    EXPECT_LT(covering.states[resting].velocity.norm(), 1e-9) << resting;
  }
  EXPECT_EQ(measure_imu(path, {0, 1}, options, {0.2, 0.8}).samples.size(), alone.samples.size());
}

TEST(Imu, RefusesOptionsThatMakeNoSense) {
  EXPECT_EQ(support::error_text([] { ImuOptions{.noise = {.rate = 0}}.validate(); }),
            "imu: expected a rate above 0 and at most 100000 Hz, got 0");
  EXPECT_THROW((ImuOptions{.noise = {.rate = 200, .gyro_noise = -1}}.validate()), vo::Error);
}

}  // namespace
}  // namespace synth
