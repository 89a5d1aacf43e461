#include "tools/scenario/mono_scenario.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using vo::SE3;

constexpr double kLength = 2;  // m

/// Along a quarter of a circle, `size` times as large.
vo::Trajectory quarter_circle(double size) {
  constexpr int kPoses = 101;
  vo::Trajectory trajectory;
  for (int i = 0; i < kPoses; ++i) {
    const double angle = 0.5 * M_PI * i / (kPoses - 1);
    const double radius = size * kLength / (0.5 * M_PI);
    trajectory.push_back({i / 30.0, SE3(Eigen::Quaterniond::Identity(),
                                        {radius * std::cos(angle), 0, radius * std::sin(angle)})});
  }
  return trajectory;
}

tools::TrackingRun run_of_size(double size) {
  tools::TrackingRun run;
  run.tracking.trajectory = quarter_circle(size);
  run.tracking.frames.resize(run.tracking.trajectory.size());
  run.maps.resize(2);
  run.maps[0].errors.scale = 1.01;
  run.maps[1].errors.scale = 1.01 * 1.004;
  run.maps[1].errors.confident = {
      .count = 100, .median_percent = 0.3, .p90_percent = 1, .outliers_percent = 2, .nees = 1.5};
  run.maps[1].errors.density_percent = 70;
  return run;
}

tools::Metrics measured(const tools::Scenario& scenario, const tools::TrackingRun& run) {
  const vo::Trajectory truth = quarter_circle(1);
  tools::Metrics metrics = tools::measure(truth, run.tracking, scenario.score);
  tools::measure_map(scenario, truth, run, metrics);
  return metrics;
}

tools::Scenario scenario_of(tools::OdometryMode mode, vo::MonoBootstrap bootstrap) {
  tools::Scenario scenario;
  scenario.odometry.mode = mode;
  scenario.odometry.mono.bootstrap = bootstrap;
  return scenario;
}

/// 2 m of path: 0.4 % from the first map to the last are 2 % per 10 m.
TEST(MonoScenario, ScaleIsThatOfTheTrajectoryAndItsDriftThatOfTheMaps) {
  const tools::Metrics metrics =
      measured(scenario_of(tools::OdometryMode::mono, vo::MonoBootstrap::rgbd), run_of_size(1.02));
  EXPECT_NEAR(metrics.scale_error_percent, 2, 1e-6);
  EXPECT_NEAR(metrics.scale_drift_percent, 2, 1e-3);
  EXPECT_NEAR(metrics.ate_percent, 100 * metrics.ate_rmse_m / kLength, 1e-3);
  EXPECT_EQ(metrics.depth_error_percent, 0.3);
  EXPECT_EQ(metrics.depth_outliers_percent, 2);
  EXPECT_EQ(metrics.depth_nees, 1.5);
  EXPECT_NEAR(metrics.depth_density_fraction, 0.7, 1e-12);
}

TEST(MonoScenario, AnArbitraryScaleIsNoError) {
  tools::Scenario scenario = scenario_of(tools::OdometryMode::mono, vo::MonoBootstrap::automatic);
  scenario.score.align = vo::TrajectoryAlignment::sim3;
  const tools::Metrics metrics = measured(scenario, run_of_size(3));
  EXPECT_TRUE(std::isnan(metrics.scale_error_percent));
  EXPECT_TRUE(std::isnan(metrics.drift_percent));
  EXPECT_NEAR(metrics.ate_percent, 0, 1e-6);
}

TEST(MonoScenario, MappingAloneHasNoTrajectoryToJudge) {
  tools::TrackingRun run = run_of_size(1);
  run.tracking = {};
  const tools::Metrics metrics =
      measured(scenario_of(tools::OdometryMode::mapping, vo::MonoBootstrap::rgbd), run);
  EXPECT_TRUE(std::isnan(metrics.tracked_fraction));
  EXPECT_TRUE(std::isnan(metrics.ate_rmse_m));
  EXPECT_EQ(metrics.depth_error_percent, 0.3);
}

}  // namespace
