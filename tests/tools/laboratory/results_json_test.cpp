#include "tools/laboratory/results_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/files/output.h"

namespace {

tools::TestResults two_scenarios() {
  tools::TestResults results{.edvo = "1.2.3", .tracker = "edvo"};
  tools::ScenarioResult bounded{.name = "bounded", .why = "a reason"};
  bounded.trials.push_back({.seed = 4, .sequence = "sequence", .frames = 30});
  bounded.trials.back().metrics.ate_rmse_m = 0.25;
  bounded.checks.push_back({"ate_rmse_m", 0.25, {.max = 0.5}, true});
  bounded.checks.push_back({"tracked_fraction", 0.75, {.min = 1}, false});
  tools::ScenarioResult failed{.name = "failed"};
  failed.trials.push_back({.seed = 5, .sequence = "other", .problem = "no such file"});
  failed.trials.push_back({.seed = 6, .problem = "it crashed", .kind = tools::ProblemKind::crash});
  results.scenarios = {bounded, failed};
  return results;
}

TEST(ResultsJson, WhatIsReadIsWrittenAlike) {
  const support::TempFolder folder;
  const auto file = folder.path() / "results.json";
  const std::string written = tools::results_json(two_scenarios()).dump();
  vo::write_file(file, written);
  const tools::TestResults read = tools::read_results(file);
  EXPECT_EQ(tools::results_json(read).dump(), written);
  EXPECT_EQ(read.scenarios[1].trials[1].kind, tools::ProblemKind::crash);
}

TEST(ResultsJson, KnowsWhichMetricsAFileDoesNotName) {
  const support::TempFolder folder;
  const auto file = folder.path() / "results.json";
  nlohmann::json json = tools::results_json(two_scenarios());
  for (nlohmann::json& scenario : json["scenarios"]) {
    for (nlohmann::json& trial : scenario["trials"]) {
      trial["metrics"].erase("nees_p90");
    }
  }
  vo::write_file(file, json.dump());
  EXPECT_EQ(tools::read_results(file).unknown_metrics, std::set<std::string>{"nees_p90"});
}

TEST(ResultsJson, IsRefusedWithSeedsAndFramesThatCannotBe) {
  const support::TempFolder folder;
  const auto file = folder.path() / "results.json";
  const auto error_with = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json json = tools::results_json(two_scenarios());
    json["scenarios"][1]["trials"][1][key] = value;
    vo::write_file(file, json.dump(), vo::ExistingOutput::replace);
    return support::error_text([&] { tools::read_results(file); });
  };
  for (const char* key : {"seed", "frames"}) {
    for (const nlohmann::json& value :
         {nlohmann::json(1e30), nlohmann::json(-5), nlohmann::json(0.5), nlohmann::json(1e99)}) {
      EXPECT_EQ(error_with(key, value), file.string() + ": failed: " + key +
                                            ": expected a whole number from 0 to 2147483647, got " +
                                            value.dump());
    }
  }
  EXPECT_THAT(error_with("seed", "6"), testing::HasSubstr("2147483647, got string"));
  EXPECT_EQ(error_with("seed", 5), file.string() +
                                       ": failed: seed: 5 is there twice, expected trials of "
                                       "different seeds");
}

TEST(ResultsJson, IsRefusedWithTwoScenariosOfOneName) {
  const support::TempFolder folder;
  tools::TestResults results = two_scenarios();
  results.scenarios[1].name = "bounded";
  const auto file = folder.write("results.json", tools::results_json(results).dump());
  EXPECT_THAT(support::error_text([&] { tools::read_results(file); }),
              testing::HasSubstr("results.json: bounded: is there twice, expected scenarios"));
}

TEST(ResultsJson, IsRefusedWithAnotherSchemaVersionWhateverItIs) {
  const support::TempFolder folder;
  nlohmann::ordered_json json = tools::results_json(two_scenarios());
  for (const char* version : {"2", "8.8e+56", "-1", "\"1\"", "null"}) {
    json["schema_version"] = nlohmann::ordered_json::parse(version);
    const auto file = folder.write("results.json", json.dump());
    EXPECT_THAT(support::error_text([&] { tools::read_results(file); }),
                testing::HasSubstr(std::string("has schema version ") + version))
        << version;
  }
}

TEST(ResultsJson, IsRefusedWhereItIsNestedTooDeep) {
  const support::TempFolder folder;
  const auto file = folder.write("results.json", R"({"schema": )" + std::string(15'000, '['));
  EXPECT_THAT(support::error_text([&] { tools::read_results(file); }),
              testing::HasSubstr("results.json: its JSON is nested more than 100 levels deep"));
}

}  // namespace
