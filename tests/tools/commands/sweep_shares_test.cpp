#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/folder_contents.h"
#include "tests/support/program_test.h"
#include "tests/support/sweep_matrix.h"

namespace {

namespace fs = std::filesystem;

using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

/// The shares of a sweep.
class SweepShares : public support::SweepMatrix {
 protected:
  ProgramResult sweep(const std::string& rest) const {
    return run_program("sweep --quiet " + matrix() + " " + rest);
  }

  ProgramResult share(const std::string& shard, const std::string& rest = "") const {
    return sweep("--trials " + path("trials") + " --shard " + shard + " " + rest);
  }

  ProgramResult collect(const std::string& rest = "") const {
    return sweep("--collect " + path("trials") + " " + rest);
  }

  /// What one process measures, in the folder `one`; returns what it prints.
  std::string sweep_by_one() const {
    const ProgramResult result = sweep("--json --out " + path("one"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  }
};

TEST_F(SweepShares, InAnyOrderComeToWhatOneProcessMeasures) {
  const std::string printed = sweep_by_one();
  EXPECT_EQ(share("3/3").out, "share 3/3: 5 trials, of which 0 were there\n");
  EXPECT_EQ(share("1/3").exit_code, 0);
  EXPECT_EQ(share("2/3").exit_code, 0);
  const ProgramResult all = collect("--json --out " + path("all"));
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(all.out, printed);
  EXPECT_EQ(support::contents(file("all")), support::contents(file("one")));
  EXPECT_EQ(share("2/5").out, "share 2/5: 3 trials, of which 3 were there\n");
  EXPECT_EQ(collect("--json").out, printed) << "without a folder it is printed alone";
}

TEST_F(SweepShares, ThatAreMissingAreNamed) {
  ASSERT_EQ(share("1/1").exit_code, 0);
  fs::remove(file("trials/a~2/seed-1.jsonl"));
  fs::remove(file("trials/b/seed-0.jsonl"));
  const ProgramResult some = collect("--shards 4 --out " + path("none"));
  EXPECT_EQ(some.exit_code, 5);
  EXPECT_EQ(some.out, "1,4\n");
  EXPECT_THAT(some.err,
              HasSubstr("2 of 16 trials are missing, shares 1,4 of 4: a seed 1, b seed 0"));
  EXPECT_FALSE(exists("none"));
}

TEST_F(SweepShares, OfOtherValuesAreNotMixed) {
  ASSERT_EQ(share("1/1").exit_code, 0);
  const ProgramResult other =
      run_program("sweep --quiet " + path("scenarios") +
                  " --set odometry.preset=paper,default --seeds 2 --collect " + path("trials"));
  EXPECT_EQ(other.exit_code, 6);
  EXPECT_THAT(other.err, HasSubstr("seed-0.jsonl: was measured with another scenario"));
}

TEST_F(SweepShares, ThatContradictAreRefused) {
  const std::string trials = "--trials " + path("trials");
  for (const std::string& rest :
       {std::string(), std::string("--shard 1/2"), std::string("--shards 2"),
        trials + " --out " + path("out"), trials + " --collect x", trials + " --shard 3/2"}) {
    EXPECT_EQ(sweep(rest).exit_code, 2) << rest;
  }
  EXPECT_THAT(sweep(trials + " --shards 0").err, HasSubstr("--shards: expected at least 1, got 0"));
  EXPECT_FALSE(exists("trials"));
}

TEST_F(SweepShares, OfValuesThatCannotBeAreRefused) {
  for (const std::string set : {"path.rate=10 --set path.rate=5", "'path.rate=[10'",
                                "'path.rate=10]]'", "'path.rate=]10['"}) {
    const ProgramResult result = run_program("sweep --quiet " + path("scenarios") + " --set " +
                                             set + " --out " + path("out"));
    EXPECT_EQ(result.exit_code, 2) << set << result.err;
    EXPECT_THAT(result.err, HasSubstr("--set path.rate=")) << set;
  }
  EXPECT_EQ(run_program("basin a.toml --set path.rate=1 --set path.rate=2 --out x").exit_code, 2);
  EXPECT_FALSE(exists("out"));
}

TEST_F(SweepShares, OfAMissingSceneAreRefusedBeforeAnythingIsRun) {
  const std::string missing = " --set scene.gltf=room/room.gltf,room/none.gltf";
  for (const std::string& rest : {"--out " + path("out"), "--trials " + path("trials")}) {
    const ProgramResult result = sweep(rest + missing);
    EXPECT_EQ(result.exit_code, 3) << rest;
    EXPECT_THAT(result.err, HasSubstr("none.gltf"));
  }
  EXPECT_FALSE(exists("trials"));
}

}  // namespace
