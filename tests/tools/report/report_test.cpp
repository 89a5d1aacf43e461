#include "tools/report/report.h"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/example_trajectory.h"

namespace {

using testing::HasSubstr;
using testing::Not;

tools::Scenario small_scenario() {
  tools::Scenario scenario;
  scenario.file = "somewhere/small.toml";
  scenario.name = "small";
  scenario.why = "because";
  scenario.expect = {{"ate_rmse_m", {.max = 0.01}}, {"keyframes", {.min = 3, .max = 5}}};
  return scenario;
}

tools::Outcome small_outcome() {
  tools::Outcome outcome;
  outcome.truth = support::example_trajectory(10, 30);
  outcome.metrics.ate_rmse_m = 0.0025;
  outcome.metrics.keyframes = 7;
  outcome.metrics.drift_percent = std::nan("");
  outcome.checks = {{"ate_rmse_m", 0.0025, {.max = 0.01}, true},
                    {"keyframes", 7, {.min = 3, .max = 5}, false}};
  return outcome;
}

TEST(Report, TableShowsEveryMetricItsBoundAndTheVerdict) {
  const std::string table = tools::report_table(small_scenario(), small_outcome());
  EXPECT_THAT(table, HasSubstr("ate_rmse_m                  0.0025        <= 0.01       ok\n"));
  EXPECT_THAT(table,
              HasSubstr("keyframes                   7             >= 3, <= 5    VIOLATED\n"));
  EXPECT_THAT(table, Not(HasSubstr("\ndrift_percent"))) << "neither asked for nor measured";
  EXPECT_THAT(table, HasSubstr("FAIL  1 of 2 bounds\n"));
}

TEST(Report, JsonHasMetricsBoundsAndOptions) {
  const auto document = tools::report_json(small_scenario(), small_outcome());
  EXPECT_EQ(document["passed"], false);
  EXPECT_EQ(document["metrics"]["ate_rmse_m"], 0.0025);
  EXPECT_TRUE(document["metrics"]["drift_percent"].is_null()) << "JSON has no NaN";
  EXPECT_TRUE(document["bounds"]["ate_rmse_m"]["min"].is_null());
  EXPECT_EQ(document["options"]["odometry.tracker.pyramid.levels"], 3);
}

TEST(Report, MarkdownHasTheCommandThatRepeatsTheRunAndItsFolder) {
  tools::Scenario scenario = small_scenario();
  scenario.file = "my scenarios/small.toml";
  EXPECT_THAT(tools::report_markdown(scenario, small_outcome()),
              HasSubstr("Repeat in `" + std::filesystem::current_path().string() +
                        "` with `edvo run 'my scenarios/small.toml' --out small_again`"));
}

}  // namespace
