#include "tools/outside_tracker/plausibility.h"

#include <cmath>
#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "vo/core/random.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

using testing::HasSubstr;
using vo::Trajectory;

constexpr auto kAligned = vo::TrajectoryAlignment::se3;

/// A walk along a curve, 100 poses.
Trajectory curve() {
  Trajectory trajectory;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.05 * i;
    trajectory.push_back({t, vo::SE3(Eigen::Quaterniond::Identity(),
                                     {std::cos(t), 0.3 * std::sin(3 * t), std::sin(t)})});
  }
  return trajectory;
}

/// Returns the trajectory with errors of this deviation in each coordinate, rounded to `unit`.
Trajectory written(Trajectory trajectory, double deviation, double unit, std::uint64_t seed = 1) {
  vo::Random random(seed);
  for (vo::StampedPose& pose : trajectory) {
    Eigen::Vector3d position = pose.T_world_camera.translation();
    for (double& coordinate : position) {
      coordinate = unit * std::round((coordinate + deviation * random.normal()) / unit);
    }
    pose.T_world_camera = vo::SE3(pose.T_world_camera.rotation(), position);
  }
  return trajectory;
}

TEST(Plausibility, ReadsTheUnitOfTheLastDigit) {
  const support::TempFolder folder;
  const auto unit = [&](const std::string& text) {
    return tools::position_unit(folder.write("trajectory.txt", text));
  };
  EXPECT_DOUBLE_EQ(unit("# t x y z\n1 0.125 1.500 -2.000 0 0 0 1\n"), 1e-3);
  EXPECT_DOUBLE_EQ(unit("1 1.25e-3 1.25E-03 2.50e+01 0 0 0 1\n"), 1e-5);
  EXPECT_DOUBLE_EQ(unit("1 0 0 0 0 0 0 1\n2 0.12345 0 0 0 0 0 1\n"), 1e-5) << "zeros do not count";
  EXPECT_DOUBLE_EQ(unit("1 3 4 5 0 0 0 1\n"), 1);
  EXPECT_EQ(unit("1 0 0 0 0 0 0 1\n"), 0);
}

TEST(Plausibility, FindsTheTruthHoweverItIsRounded) {
  for (const double unit : {1e-2, 1e-3, 1e-4, 1e-6, 1e-9}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      EXPECT_NE(tools::implausibility(curve(), written(curve(), 0, unit, seed), kAligned,
                                      {.estimate = unit}),
                "")
          << unit;
    }
  }
  EXPECT_THAT(tools::implausibility(curve(), curve(), kAligned, {.truth = 1e-9}),
              HasSubstr("its ATE of "));
}

TEST(Plausibility, FindsTheTruthInAScaleOfItsOwn) {
  Trajectory small = curve();
  for (vo::StampedPose& pose : small) {
    pose.T_world_camera =
        vo::SE3(pose.T_world_camera.rotation(), 0.01 * pose.T_world_camera.translation());
  }
  const Trajectory estimate = written(small, 0, 1e-5);
  EXPECT_NE(
      tools::implausibility(curve(), estimate, vo::TrajectoryAlignment::sim3, {.estimate = 1e-5}),
      "")
      << "a millimetre of the truth";
}

TEST(Plausibility, BelievesErrorsOfTheSizeOfTheRounding) {
  for (const double unit : {1e-2, 1e-3, 1e-6}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Trajectory estimate = written(curve(), 0.5 * unit, unit, seed);
      EXPECT_EQ(tools::implausibility(curve(), estimate, kAligned, {.estimate = unit}), "") << unit;
    }
  }
}

TEST(Plausibility, BelievesThatACameraStandsStill) {
  Trajectory still = curve();
  for (vo::StampedPose& pose : still) {
    pose.T_world_camera = vo::SE3();
  }
  EXPECT_EQ(tools::implausibility(still, still, kAligned, {.truth = 1e-9}), "");
}

}  // namespace
