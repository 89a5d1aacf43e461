#include "tools/laboratory/verdict_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/terminal.h"

namespace {

using support::without_colours;
using testing::HasSubstr;
using tools::Change;
using tools::ChangeKind;
using tools::Colours;

constexpr const char* kRed = "\033[1;31m";
constexpr const char* kYellow = "\033[33m";

Change alarm(const std::string& scenario, ChangeKind kind) {
  Change change;
  change.scenario = scenario;
  change.metric = "ate_rmse_m";
  change.before = 0.01;
  change.after = 0.02;
  change.is_significant = true;
  change.is_large = true;
  change.kind = kind;
  return change;
}

TEST(VerdictTable, HasAlarmsInColoursAndTheSameTextWithout) {
  const std::vector<Change> changes = {alarm("a_long_name", ChangeKind::worse),
                                       alarm("short", ChangeKind::better)};
  const std::string plain = tools::format_changes(changes);
  const std::string coloured = tools::format_changes(changes, Colours::shown());
  EXPECT_THAT(coloured, HasSubstr(std::string(kRed) + "ALARM: worse"));
  EXPECT_THAT(coloured, HasSubstr(std::string(kYellow) + "ALARM: better"));
  EXPECT_EQ(without_colours(coloured), plain);
}

TEST(VerdictTable, HasVerdictsInColoursAndTheSameTextWithout) {
  tools::TestResults results{.tracker = "edvo"};
  results.scenarios.push_back({.name = "good", .trials = {{.seed = 0}}});
  results.scenarios.push_back({.name = "broken", .trials = {{.seed = 0, .problem = "it crashed"}}});
  const std::string plain = tools::format_verdicts(results, {});
  const std::string coloured = tools::format_verdicts(results, {}, Colours::shown());
  EXPECT_THAT(coloured, HasSubstr("\033[32m"));
  EXPECT_THAT(coloured, HasSubstr(std::string(kRed) + "FAIL"));
  EXPECT_EQ(without_colours(coloured), plain);
}

}  // namespace
