#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/program_test.h"
#include "vo/files/input.h"
#include "vo/files/output.h"

namespace {

namespace fs = std::filesystem;

using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;
using testing::Not;

/// A cache that holds what a scenario was measured with.
class CacheProgram : public support::ProgramTest {
 protected:
  CacheProgram() { write_scenario("good", "0.5"); }

  ProgramResult test() const {
    return run_program("test --quiet --cache " + path("cache") + " " + path("scenarios/good.toml"));
  }

  ProgramResult cache(const std::string& words) const {
    return run_program("cache " + words + " --cache " + path("cache"));
  }
};

TEST_F(CacheProgram, FoldersOfTheUsersAreNoEntries) {
  ASSERT_EQ(test().exit_code, 0);
  for (const char* folder : {"00", "holiday", "mine.part", ".mine.partial-edvo"}) {
    write(std::string("cache/sequences/") + folder + "/precious", "");
  }
  EXPECT_THAT(cache("verify").out, HasSubstr("1 sequences, of which 0 were broken"));
  EXPECT_THAT(cache("prune --max-size 0").out, HasSubstr("1 sequences removed"));
  for (const char* folder : {"00", "holiday", "mine.part", ".mine.partial-edvo"}) {
    EXPECT_TRUE(exists(std::string("cache/sequences/") + folder + "/precious")) << folder;
  }
}

TEST_F(CacheProgram, WhatIsKeptIsTakenAsItWasWrittenAlone) {
  ASSERT_EQ(test().exit_code, 0);
  ASSERT_THAT(test().out, HasSubstr("kept"));
  const fs::path results = file("cache/results");
  ASSERT_EQ(std::distance(fs::directory_iterator(results), fs::directory_iterator()), 1);
  const fs::path kept = fs::directory_iterator(results)->path();
  const std::string text = vo::read_file(kept);
  const std::size_t metric = text.find("0.", text.find("ate_rmse_m"));
  ASSERT_NE(metric, std::string::npos);
  std::string better = text;
  better[metric + 2] = better[metric + 2] == '1' ? '2' : '1';
  vo::write_file(kept, better, vo::ExistingOutput::replace);
  EXPECT_THAT(test().out, Not(HasSubstr("kept")));
  EXPECT_EQ(vo::read_file(kept), text);
}

}  // namespace
