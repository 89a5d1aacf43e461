#include "tools/datasets/plan_file.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/temp_folder.h"
#include "tools/datasets/sealed_document.h"
#include "vo/core/error.h"

namespace {

/// Two sequences of eleven frames that are cut into three parts each.
tools::DatasetSpec small_spec() {
  tools::DatasetSpec spec;
  spec.options.part_frames = 4;
  for (const std::string name : {"room_walk_plain_0", "room_walk_plain_1"}) {
    spec.sequences.emplace_back().name = name;
  }
  return spec;
}

tools::DatasetPlan small_plan() {
  return {
      .identity = {{"path.rate", "10"}},
      .frames = {11, 11},
      .parts = {
          {0, 0, 0, 3}, {0, 1, 3, 7}, {0, 2, 7, 11}, {1, 0, 0, 3}, {1, 1, 3, 7}, {1, 2, 7, 11}}};
}

/// Reads a plan that was changed and has the hash of what it says then, as `begin_dataset` does;
/// returns the error.
std::string error_after(const std::function<void(nlohmann::ordered_json&)>& change) {
  const support::TempFolder folder;
  auto document = nlohmann::ordered_json::parse(tools::format_plan(small_spec(), small_plan()));
  change(document);
  const auto file = folder.write("plan.json", tools::sealed_text(document));
  try {
    tools::require_plan_of(small_spec(), tools::read_plan(file), file);
  } catch (const vo::Error& error) {
    return error.what();
  }
  return "";
}

TEST(PlanFile, IsReadAsItWasWritten) {
  const support::TempFolder folder;
  const auto file =
      folder.write("plan.json", tools::format_sealed_plan(small_spec(), small_plan()));
  EXPECT_EQ(tools::format_plan(small_spec(), tools::read_plan(file)),
            tools::format_plan(small_spec(), small_plan()));
  EXPECT_EQ(error_after([](nlohmann::ordered_json& /*plan*/) {}), "");
}

/// Parts of the plan record its hash, which plan.json has, too.
TEST(PlanFile, HasTheHashThatPartsRecord) {
  const auto sealed = nlohmann::json::parse(tools::format_sealed_plan(small_spec(), small_plan()));
  EXPECT_EQ(sealed.at("hash"), tools::plan_hash(small_spec(), small_plan()));
}

/// The hash of a plan keeps nobody from making one up: what it says is held to the spec.
TEST(PlanFile, IsHeldToTheSpec) {
  const auto expect = [](const std::string& problem,
                         const std::function<void(nlohmann::ordered_json&)>& change) {
    const std::string error = error_after(change);
    EXPECT_NE(error.find("plan.json: " + problem), std::string::npos) << error;
  };
  using Json = nlohmann::ordered_json;
  expect("sequences: frames: got -1", [](Json& plan) { plan["sequences"][0]["frames"] = -1; });
  expect("sequences: frames: got 11.0", [](Json& plan) { plan["sequences"][0]["frames"] = 11.0; });
  expect("sequences: 5000 frames", [](Json& plan) { plan["sequences"][0]["frames"] = 5000; });
  expect("sequences: got 1, expected 2", [](Json& plan) { plan["sequences"].erase(1); });
  expect("cameras: got 100000000.0", [](Json& plan) { plan["cameras"] = 1e8; });
  expect("cameras: got 0, expected 1", [](Json& plan) { plan["cameras"] = 0; });
  expect("parts: got \"0\"", [](Json& plan) { plan["parts"][0][2] = "0"; });
  expect("no plan of a data set", [](Json& plan) { plan["parts"][0] = {0, 0}; });
  expect("no plan of a data set", [](Json& plan) { plan.erase("identity"); });
  expect("parts: 0 that are not the 6", [](Json& plan) { plan["parts"].clear(); });
  expect("parts: 5 that are not the 6", [](Json& plan) { plan["parts"].erase(2); });
  expect("parts: 7 that are not the 6", [](Json& plan) { plan["parts"].push_back({1, 2, 7, 11}); });
  expect("parts: 6 that are not the 6", [](Json& plan) { plan["parts"][1] = {0, 1, 2, 7}; });
}

/// A plan without hash is another data set's, as far as this edvo knows: exit code 6, not 3.
TEST(PlanFile, OfAnEarlierVersionIsAnotherDataSet) {
  const support::TempFolder folder;
  const auto file = folder.write("plan.json", tools::format_plan(small_spec(), small_plan()));
  try {
    tools::read_plan(file);
    FAIL() << "it was read";
  } catch (const vo::Error& error) {
    EXPECT_EQ(error.kind(), vo::ErrorKind::output_exists);
    EXPECT_NE(std::string(error.what()).find("written by an earlier edvo"), std::string::npos);
  }
}

}  // namespace
