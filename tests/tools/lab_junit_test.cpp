#include <gtest/gtest.h>

#include "tools/lab/junit.h"

namespace {

TEST(Junit, HasACasePerScenarioAndSaysWhatFailed) {
  const tools::ScenarioResult good{.name = "still", .why = "", .trials = {{.time = 1.25}}};
  const tools::ScenarioResult bad{
      .name = "orbit",
      .why = "",
      .trials = {{.time = 2}},
      .checks = {{.metric = "ate_rmse_m", .measured = 0.5, .bound = {.max = 0.25}}}};
  const tools::ScenarioResult broken{
      .name = "odd", .why = "", .trials = {{.problem = "a.toml:3: unknown key \"<x>\" & more"}}};
  const tools::TestResults results{
      .edvo = "1", .tracker = "edvo", .scenarios = {good, bad, broken}};
  const tools::Change change{.scenario = "still",
                             .metric = "ate_rmse_m",
                             .before = 1,
                             .after = 2,
                             .percent = 100,
                             .p_value = 0,
                             .kind = tools::ChangeKind::worse,
                             .is_significant = true,
                             .is_large = true};
  EXPECT_EQ(tools::format_junit(results, {change}), R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="edvo test" tests="3" failures="2" errors="1" time="3.250">
  <testsuite name="edvo" tests="3" failures="2" errors="1" time="3.250">
    <testcase classname="edvo.scenarios" name="still" time="1.250">
      <failure type="baseline" message="still: ate_rmse_m was 1, is 2 (+100.0 %, p 0): worse"/>
    </testcase>
    <testcase classname="edvo.scenarios" name="orbit" time="2.000">
      <failure type="bound" message="ate_rmse_m is 0.5, expected &lt;= 0.25"/>
    </testcase>
    <testcase classname="edvo.scenarios" name="odd" time="0.000">
      <error type="not_measured" message="a.toml:3: unknown key &quot;&lt;x&gt;&quot; &amp; more"/>
    </testcase>
  </testsuite>
</testsuites>
)");
}

}  // namespace
