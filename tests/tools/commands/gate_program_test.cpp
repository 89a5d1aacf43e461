#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace {

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;
using testing::Not;

/// A gate for a tracker that is not edvo's: a camera of constant velocity, in Python.
class TrackerGate : public support::ProgramTest {
 protected:
  TrackerGate() { write_scenario("good", "1e-9"); }

  /// Tests the tracker at a speed in m/s.
  ProgramResult test(const std::string& rest, const std::string& speed = "0.1") const {
    return run_program("test --quiet --cache " + path("cache") + " " + path("scenarios") +
                           " --tracker \"python3 '" EDVO_SOURCE_DIR
                           "/tests/peers/constant_velocity.py' {sequence} {output} " +
                           speed + "\" " + rest,
                       "cd " + path("") + " && ");
  }

  /// Writes the scenario without the bounds that its file ends with.
  void drop_bounds() const {
    const std::string text = read("scenarios/good.toml");
    write("scenarios/good.toml", text.substr(0, text.find("[expect]")));
  }

  double ate(const std::string& file) const {
    const json results = json::parse(read(file));
    return results["scenarios"][0]["metrics"]["ate_rmse_m"]["mean"].get<double>();
  }
};

TEST_F(TrackerGate, ABaselineOfItsOwnJudgesATrackerInPlaceOfEdvosBounds) {
  const ProgramResult saved = test("--save-baseline " + path("mine.json"));
  EXPECT_EQ(saved.exit_code, 4) << "the scenario's bound is edvo's";
  ASSERT_TRUE(exists("mine.json")) << saved.err;
  const ProgramResult same = test("--baseline " + path("mine.json"));
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_THAT(same.out, HasSubstr("PASS  1 scenarios, 1 measured"));
  EXPECT_EQ(test("--bounds scenario --baseline " + path("mine.json")).exit_code, 4);
}

TEST_F(TrackerGate, AnErrorThatGrowsByATenthIsCaught) {
  ASSERT_EQ(test("--bounds none --save-baseline " + path("mine.json"), "0.2").exit_code, 0);
  const ProgramResult worse = test("--baseline " + path("mine.json") + " --json " + path("r.json") +
                                       " --junit " + path("junit.xml"),
                                   "0.17");
  ASSERT_GT(ate("r.json"), 1.1 * ate("mine.json"));
  ASSERT_LT(ate("r.json"), 1.3 * ate("mine.json"));
  EXPECT_EQ(worse.exit_code, 4) << worse.out;
  EXPECT_THAT(worse.out, HasSubstr("good: ate_rmse_m was "));
  EXPECT_THAT(read("junit.xml"), HasSubstr("<failure type=\"baseline\""));
}

TEST_F(TrackerGate, AScenarioNeedsNoBoundsWhereOthersJudge) {
  drop_bounds();
  const ProgramResult without = test("");
  EXPECT_EQ(without.exit_code, 3);
  EXPECT_THAT(without.out, HasSubstr("expected at least one bound, or --bounds baseline or none"));
  EXPECT_EQ(test("--bounds none --save-baseline " + path("mine.json")).exit_code, 0);
  EXPECT_EQ(test("--baseline " + path("mine.json")).exit_code, 0);
  EXPECT_EQ(run_program("run " + path("scenarios/good.toml") + " --out " + path("run")).exit_code,
            0)
      << "nothing is expected";
}

TEST_F(TrackerGate, JudgesThatContradictEachOtherAreRefused) {
  for (const char* options :
       {"--bounds baseline", "--bounds none --baseline b.json", "--bounds mine",
        "--update-baseline", "--baseline b.json --update-baseline --save-baseline c.json"}) {
    EXPECT_EQ(test(options).exit_code, 2) << options;
  }
}

TEST_F(TrackerGate, WhatWasNotMeasuredIsNoBaseline) {
  ASSERT_EQ(test("--bounds none --save-baseline " + path("mine.json")).exit_code, 0);
  const std::string before = read("mine.json");
  const ProgramResult broken = test("--bounds none --save-baseline " + path("mine.json"), "fast");
  EXPECT_EQ(broken.exit_code, 4) << broken.out;
  EXPECT_THAT(broken.err, HasSubstr("good: was not measured and is not put into "));
  EXPECT_EQ(json::parse(before)["scenarios"], json::parse(read("mine.json"))["scenarios"]);
}

TEST_F(TrackerGate, ABaselineOfAnotherTrackerIsSaid) {
  ASSERT_EQ(test("--bounds none --save-baseline " + path("mine.json")).exit_code, 0);
  EXPECT_THAT(test("--baseline " + path("mine.json")).err, Not(HasSubstr("was measured with")));
  EXPECT_THAT(test("--baseline " + path("mine.json"), "0.2").err,
              HasSubstr("the baseline was measured with the tracker 'python3 "));
}

TEST_F(TrackerGate, TheReportNamesTheTrackerAndShowsWhatItGaveAlone) {
  ASSERT_EQ(test("--bounds none --report " + path("r.html")).exit_code, 0);
  const std::string html = read("r.html");
  const std::string opening = "id=\"edvo-data\">";
  const std::size_t start = html.find(opening) + opening.size();
  const json scenario =
      json::parse(html.substr(start, html.find("</script>", start) - start))["scenarios"][0];
  EXPECT_THAT(scenario["tracker"].get<std::string>(), HasSubstr("constant_velocity.py"));
  EXPECT_FALSE(scenario["frames"].contains("tracking"));
  EXPECT_EQ(scenario["frames"]["status"][1], "tracked");
  for (const json& option : scenario["options"]) {
    EXPECT_THAT(option["key"].get<std::string>(), Not(testing::StartsWith("odometry.")));
  }
  const std::string repeat = scenario["command"].get<std::string>();
  ASSERT_TRUE(repeat.starts_with("edvo "));
  const ProgramResult again = run_program(repeat.substr(5) + " --cache " + path("cache"),
                                          "cd '" + scenario["folder"].get<std::string>() + "' && ");
  EXPECT_EQ(again.exit_code, 0) << repeat << "\n" << again.err;
}

}  // namespace
