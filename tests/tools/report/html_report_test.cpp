#include "tools/report/html_report.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/plane_report.h"
#include "tools/report/report_data.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr tools::ReportBundle kBundle{"start()", "body{}", ""};

json data_of(const std::string& html) {
  const std::string opening = "id=\"edvo-data\">";
  const auto start = html.find(opening) + opening.size();
  return json::parse(html.substr(start, html.find("</script>", start) - start));
}

TEST(ReportData, TheCurveOfPositionErrorsHasTheAteAsItsRootMeanSquare) {
  const tools::ScenarioReport report = support::plane_report(12, 12);
  const auto data = tools::report_data({report});
  double squares = 0;
  for (const auto& error : data["scenarios"][0]["frames"]["position_m"]) {
    squares += error.get<double>() * error.get<double>();
  }
  EXPECT_NEAR(std::sqrt(squares / 12), vo::evaluate(report.truth, report.estimate).ate.rmse, 1e-6);
}

TEST(ReportData, OfAnotherProcessIsPassedOn) {
  tools::ScenarioReport report = support::plane_report(8, 6);
  report.problem = "it was odd";
  report.notes = {"a note"};
  report.metrics = {{"ate_rmse_m", 0.5, tools::Bound{.max = 0.25}, false}, {"keyframes", NAN, {}}};
  const auto data = tools::report_data({report});
  tools::ScenarioReport passed_on = tools::report_of_data(data["scenarios"][0]);
  EXPECT_EQ(tools::report_data({passed_on}), data);
  EXPECT_EQ(passed_on.estimate.size(), report.estimate.size());
  passed_on.problem.clear();
  passed_on.name = "renamed";
  const auto changed = tools::report_data({passed_on})["scenarios"][0];
  EXPECT_FALSE(changed.contains("problem"));
  EXPECT_EQ(changed["name"], "renamed");
  EXPECT_EQ(changed["pictures"], data["scenarios"][0]["pictures"]);
}

TEST(ReportData, EveryQuantityHasOneElementPerFrameAndLostFramesHaveNoPose) {
  const auto data = tools::report_data({support::plane_report(8, 6)});
  const auto& frames = data["scenarios"][0]["frames"];
  for (const auto& [name, values] : frames.items()) {
    if (name != "tracking") {
      EXPECT_EQ(values.size(), 8U) << name;
    }
  }
  for (const auto& [name, values] : frames["tracking"].items()) {
    EXPECT_EQ(values.size(), 8U) << name;
  }
  EXPECT_EQ(frames["status"][7], "lost");
  EXPECT_TRUE(frames["estimate"][7].is_null());
  EXPECT_EQ(frames["truth"][7].size(), 7U);
}

TEST(ReportData, AnotherTrackersPosesAreEnough) {
  tools::ScenarioReport report = support::plane_report(6, 6);
  report.frames.clear();
  report.gallery = tools::FrameGallery();
  report.estimate.erase(report.estimate.begin() + 2);
  const auto data = tools::report_data({report});
  const auto& scenario = data["scenarios"][0];
  EXPECT_EQ(scenario["frames"]["timestamp"].size(), 6U);
  EXPECT_TRUE(scenario["frames"]["estimate"][2].is_null());
  EXPECT_FALSE(scenario["frames"].contains("tracking"));
  EXPECT_FALSE(scenario.contains("cloud"));
}

TEST(ReportData, OfAnotherTrackersFramesTheStatusAloneIsShown) {
  tools::ScenarioReport report = support::plane_report(6, 6);
  report.tracker = "my_vo {sequence} {output}";
  const auto data = tools::report_data({report});
  const auto& scenario = data["scenarios"][0];
  EXPECT_EQ(scenario["tracker"], report.tracker);
  EXPECT_EQ(scenario["frames"]["status"][5], "tracked");
  EXPECT_FALSE(scenario["frames"].contains("tracking"));
}

TEST(ReportData, AScenarioWithoutResultHasFailedAndSaysWhy) {
  tools::ScenarioReport report;
  report.name = "crashed";
  report.problem = "the tracker ended with signal 11";
  const auto data = tools::report_data({report});
  EXPECT_EQ(data["scenarios"][0]["passed"], false);
  EXPECT_EQ(data["scenarios"][0]["problem"], "the tracker ended with signal 11");
}

TEST(ReportData, TimesAreThereOnlyWhenAsked) {
  tools::ScenarioReport report = support::plane_report(3, 3);
  EXPECT_FALSE(tools::report_data({report})["scenarios"][0].contains("times"));
  report.times = std::vector<vo::StageTimes>(3, {.pyramid_ms = 1});
  EXPECT_EQ(tools::report_data({report})["scenarios"][0]["times"]["pyramid_ms"][2], 1.0);
}

TEST(HtmlReport, HoldsItsDataWhateverTheNamesAre) {
  tools::ScenarioReport report = support::plane_report(4, 4);
  report.name = "</script><script>alert(1)</script><!-- \xff";
  const std::string html = tools::html_report({report}, kBundle);
  EXPECT_EQ(html.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(data_of(html)["scenarios"][0]["name"],
            "</script><script>alert(1)</script><!-- \xef\xbf\xbd");
}

TEST(HtmlReport, EqualReportsGiveEqualBytesAndLoadNothingFromElsewhere) {
  const std::string html = tools::html_report({support::plane_report(6, 5)});
  EXPECT_EQ(html, tools::html_report({support::plane_report(6, 5)}));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  EXPECT_EQ(html.find("<link"), std::string::npos);
  EXPECT_EQ(html.find("src=\"http"), std::string::npos);
}

TEST(HtmlReport, WithoutItsBundleItShowsVerdictsAndTrajectoriesAndSaysWhatIsAbsent) {
  tools::ScenarioReport report = support::plane_report(6, 6);
  report.metrics = {{"ate_rmse_m", 0.002, tools::Bound{.max = 0.001}, false}};
  report.why = "a < b";
  const std::string html = tools::html_report({report}, {"", "", "npm was missing"});
  EXPECT_THAT(html, HasSubstr("npm was missing"));
  EXPECT_THAT(html, HasSubstr("plane: FAIL"));
  EXPECT_THAT(html, HasSubstr("<td>0.002</td><td>&lt;= 0.001</td><td>VIOLATED</td>"));
  EXPECT_THAT(html, HasSubstr("a &lt; b"));
  EXPECT_THAT(html, HasSubstr("</svg>"));
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

}  // namespace
