#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace {

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

const std::string kScene =
    std::string("'") + EDVO_SOURCE_DIR + "/assets/plane_and_box/plane_and_box.gltf'";

/// Straight towards the box, whose front is z = 1.
constexpr const char* kApproach =
    " --path dolly --move.eye 0.25,0,3 --move.target 0.25,0,0 --move.by 0,0,1.5 --rate 5 "
    "--duration 2";

TEST(PathProgram, ChecksAPathInClosedForm) {
  const ProgramResult result = run_program("path check " + kScene + kApproach + " --json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["frames"], 11);
  EXPECT_NEAR(report["clearance"]["min"], 0.5, 1e-6);
  EXPECT_NEAR(report["length"], 1.5, 1e-9);
  EXPECT_NEAR(report["speed"]["max"], 1.0, 1e-6) << "1.5 m in 2 s less a ramp of 0.5 s";
  EXPECT_EQ(report["per_frame"].size(), 11U);
}

TEST(PathProgram, AViolatedLimitIsExitCode4) {
  const ProgramResult result =
      run_program("path check " + kScene + kApproach + " --limit.min-clearance 0.6");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.out, HasSubstr("violated: min_clearance: got 0.5, limit 0.6"));
}

TEST(PathProgram, ExploresASceneWithoutAnyPoses) {
  const std::string explore =
      "path check " + kScene + " --path explore --duration 4 --rate 5 --json";
  const ProgramResult result = run_program(explore);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["collisions"], 0);
  EXPECT_EQ(report["blank_views"], 0);
  EXPECT_GT(report["length"], 0.1);
  EXPECT_EQ(run_program(explore).out, result.out) << "it is a function of its inputs";
}

TEST(PathProgram, ASceneAndAPathAreNeeded) {
  EXPECT_EQ(run_program("path check").exit_code, 2);
  EXPECT_EQ(run_program("path check " + kScene).exit_code, 2) << "and a path";
}

}  // namespace
