#include <filesystem>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/folder_contents.h"
#include "tests/support/program_test.h"
#include "tools/processes/shell_words.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

/// A scenario that passes, one that does not, and one that cannot be read, each with two seeds.
class SharesProgram : public support::ProgramTest {
 protected:
  SharesProgram() {
    write_scenario("a", "0.5\n[sensor]\npreset = \"kinect-v1\"");
    write_scenario("b", "1e-9");
  }

  void write_unusable() const { write_scenario("c", "1\n[sensor]\nexposre = 1"); }

  ProgramResult test(const std::string& rest, const std::string& before = "") const {
    return run_program(
        "test --quiet --seeds 2 --cache " + path("cache") + " " + path("scenarios") + " " + rest,
        before);
  }

  ProgramResult share(const std::string& shard, const std::string& rest = "") const {
    return test("--trials " + path("trials") + " --shard " + shard + " " + rest);
  }

  ProgramResult collect(const std::string& rest = "") const {
    return test("--collect " + path("trials") + " " + rest);
  }

  std::string outputs(const std::string& stem) const {
    return " --json " + path(stem + ".json") + " --junit " + path(stem + ".xml") + " --report " +
           path(stem + ".html");
  }
};

/// The text without what the clock said: JUnit's times and the last column of the table.
std::string without_times(const std::string& text) {
  const std::string junit = std::regex_replace(text, std::regex("time=\"[0-9.]*\""), "");
  return std::regex_replace(junit, std::regex(" +(kept|[0-9.]+)\n"), "\n");
}

TEST_F(SharesProgram, SharesInAnyOrderComeToWhatOneProcessMeasures) {
  write_unusable();
  const ProgramResult one = test(outputs("one"));
  EXPECT_EQ(one.exit_code, 3);
  const ProgramResult third = share("3/3");
  EXPECT_EQ(third.exit_code, 3);
  EXPECT_EQ(third.out, "share 3/3: 2 trials, of which 0 were there\n");
  EXPECT_THAT(third.err, HasSubstr("c: "));
  EXPECT_THAT(third.err, HasSubstr("unknown key 'sensor.exposre'"));
  EXPECT_EQ(share("2/3").exit_code, 3);
  EXPECT_EQ(share("1/3").exit_code, 0);
  const ProgramResult all = collect(outputs("all"));
  EXPECT_EQ(all.exit_code, one.exit_code);
  EXPECT_EQ(without_times(all.out), without_times(one.out));
  EXPECT_EQ(read("all.json"), read("one.json"));
  EXPECT_EQ(read("all.html"), read("one.html"));
  EXPECT_EQ(without_times(read("all.xml")), without_times(read("one.xml")));
  collect(outputs("again"));
  EXPECT_EQ(read("again.xml"), read("all.xml"));
}

TEST_F(SharesProgram, ABaselineIsComparedWithWhenAllIsThere) {
  ASSERT_EQ(test("--bounds none --save-baseline " + path("baseline.json")).exit_code, 0);
  EXPECT_EQ(share("1/1").exit_code, 0);
  EXPECT_EQ(collect("--bounds baseline --baseline " + path("baseline.json")).exit_code, 0);
  EXPECT_EQ(collect().exit_code, 4);
}

TEST_F(SharesProgram, WhatIsThereIsNotRunAgain) {
  ASSERT_EQ(share("1/1").exit_code, 0);
  const auto before = support::contents(file("trials"));
  EXPECT_EQ(before.size(), 4U);
  const ProgramResult second = share("1/2");
  EXPECT_EQ(second.exit_code, 0);
  EXPECT_EQ(second.out, "share 1/2: 2 trials, of which 2 were there\n");
  EXPECT_EQ(support::contents(file("trials")), before);
  EXPECT_EQ(share("1/1", "--again").exit_code, 0);
  EXPECT_NE(support::contents(file("trials")), before);
}

TEST_F(SharesProgram, MissingAndDamagedTrialsAreNamedWithTheSharesToRunAgain) {
  ASSERT_EQ(share("1/1").exit_code, 0);
  fs::remove(file("trials/a/seed-1.jsonl"));
  std::string bytes = read("trials/b/seed-1.jsonl");
  bytes[bytes.size() / 2] ^= 1;
  write("trials/b/seed-1.jsonl", bytes);
  const ProgramResult some = collect("--shards 3" + outputs("none"));
  EXPECT_EQ(some.exit_code, 5);
  EXPECT_EQ(some.out, "1-2\n");
  EXPECT_THAT(some.err,
              HasSubstr("2 of 4 trials are missing, shares 1-2 of 3: a seed 1, b seed 1 "));
  EXPECT_THAT(some.err, HasSubstr("b/seed-1.jsonl: its bytes are not those that were written"));
  EXPECT_FALSE(exists("none.json"));
  EXPECT_EQ(collect().out, "2,4\n");
  for (const std::string task : {"1", "2"}) {
    EXPECT_EQ(test("--shards 3 --trials " + path("trials"), "SLURM_ARRAY_TASK_ID=" + task + " ")
                  .exit_code,
              0);
  }
  EXPECT_EQ(collect("--bounds none").exit_code, 0);
}

TEST_F(SharesProgram, TrialsOfAnotherTrackerOrScenarioAreNotMixed) {
  ASSERT_EQ(share("1/1").exit_code, 0);
  const std::string tracker =
      " --bounds none --tracker " + tools::shell_quoted("true {sequence} {output}");
  const ProgramResult other = collect(tracker);
  EXPECT_EQ(other.exit_code, 6);
  EXPECT_THAT(other.err, HasSubstr("a/seed-0.jsonl: was measured with another tracker"));
  std::string scenario = read("scenarios/b.toml");
  scenario.replace(scenario.find("1e-9"), 4, "0.5 ");
  write("scenarios/b.toml", scenario);
  EXPECT_EQ(collect().exit_code, 0) << "bounds judge a trial and do not change it";
  scenario.replace(scenario.find("height = 120"), 12, "height = 112");
  write("scenarios/b.toml", scenario);
  EXPECT_THAT(collect().err, HasSubstr("b/seed-0.jsonl: was measured with another scenario"));
  const ProgramResult again = share("1/1");
  EXPECT_EQ(again.exit_code, 6);
  EXPECT_EQ(share("1/1", "--again").exit_code, 0);
  EXPECT_EQ(collect().exit_code, 0);
}

TEST_F(SharesProgram, ATrackerThatFailsIsAResult) {
  const std::string tracker = " --tracker " + tools::shell_quoted("false {sequence} {output}");
  EXPECT_EQ(share("1/1", tracker).exit_code, 0);
  const ProgramResult all = collect(tracker + outputs("all"));
  EXPECT_EQ(all.exit_code, 4);
  EXPECT_EQ(json::parse(read("all.json"))["scenarios"][1]["trials"][1]["problem_kind"], "tracker");
}

TEST_F(SharesProgram, AShareThatIsEndedGoesOn) {
  const std::string tracker =
      " --jobs 1 --tracker " + tools::shell_quoted("sh -c 'test -e " + file("go").string() +
                                                   " || sleep 60; exit 1' {sequence} {output}");
  const ProgramResult ended =
      run_program("test --quiet --seeds 2 --cache " + path("cache") + " " + path("scenarios") +
                      " --trials " + path("trials") + tracker,
                  "timeout --preserve-status -s TERM 3 ");
  EXPECT_EQ(ended.exit_code, 75);
  write("go", "");
  EXPECT_EQ(share("1/1", tracker).exit_code, 0);
  EXPECT_EQ(collect(tracker).exit_code, 4);
}

TEST_F(SharesProgram, TwoTasksMayRunTheSameShare) {
  ProgramResult other;
  std::thread thread([&] { other = share("1/1", "--again"); });
  const ProgramResult result = share("1/1", "--again");
  thread.join();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(other.exit_code, 0) << other.err;
  EXPECT_EQ(support::contents(file("trials")).size(), 4U);
  EXPECT_EQ(collect("--bounds none").exit_code, 0);
}

TEST_F(SharesProgram, WhatContradictsIsRefused) {
  const std::string trials = "--trials " + path("trials");
  const std::vector<std::string> contradictions{"--shard 1/2",
                                                "--shards 2",
                                                "--collect x --shard 1/2",
                                                trials + " --shard 3/2",
                                                trials + " --json x",
                                                trials + " --bounds none",
                                                trials + " --collect x",
                                                trials + " --shard 1/2 --shards 2",
                                                trials + " --shards 0"};
  for (const std::string& rest : contradictions) {
    EXPECT_EQ(test(rest).exit_code, 2) << rest;
  }
  EXPECT_EQ(test(trials + " --shards 2", "unset SLURM_ARRAY_TASK_ID; ").exit_code, 2);
  EXPECT_FALSE(exists("trials"));
}

}  // namespace
