#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/program_test.h"
#include "tests/support/sweep_matrix.h"
#include "tests/tools/submit/stand_ins.h"

namespace {

namespace fs = std::filesystem;

using support::ProgramResult;
using support::run_program;
using support::StandIns;
using testing::HasSubstr;

/// A sweep that is submitted.
class SubmittedSweep : public support::SweepMatrix {
 protected:
  ProgramResult submit(const std::string& rest) const {
    return run_program("submit --sweep " + matrix() + " " + rest);
  }
};

TEST_F(SubmittedSweep, IsMadeByAnyEngineAsByOneProcess) {
  const StandIns programs;
  programs.add("parallel",
               "while read -r share; do sh share.sh \"$share\"; done < shares.txt; exit 0");
  ASSERT_EQ(run_program("sweep --quiet " + matrix() + " --out " + path("one")).exit_code, 0);
  const ProgramResult parallel =
      submit("--out " + path("parallel") + " --engine parallel --shards 3");
  EXPECT_EQ(parallel.exit_code, 0) << parallel.err;
  EXPECT_THAT(programs.calls("parallel"), HasSubstr("--arg-file|shares.txt|"));
  const ProgramResult local = submit("--out " + path("local") + " --engine local");
  EXPECT_EQ(local.exit_code, 0) << local.err;
  for (const char* name : {"sweep.csv", "sweep.md", "sweep.svg"}) {
    const std::string expected = read(std::string("one/") + name);
    EXPECT_EQ(read(std::string("parallel/") + name), expected) << name;
    EXPECT_EQ(read(std::string("local/") + name), expected) << name;
  }
}

TEST_F(SubmittedSweep, ReplacesAnotherTableOnlyWhenToldTo) {
  write("rates/sweep.csv", "mine");
  const std::string local = "--engine local --out " + path("rates");
  EXPECT_EQ(submit(local).exit_code, 6);
  EXPECT_EQ(read("rates/sweep.csv"), "mine");
  EXPECT_EQ(submit(local + " --force").exit_code, 0);
  EXPECT_THAT(read("rates/sweep.csv"), HasSubstr("scenario,"));
}

TEST_F(SubmittedSweep, IsResumedWhereATrialIsMissing) {
  const StandIns programs;
  programs.add_slurm();
  ASSERT_EQ(submit("--out " + path("rates")).exit_code, 0);
  EXPECT_THAT(read("rates.submit/jobs.json"), HasSubstr("\"shares\": 2")) << "of eight trials each";
  ASSERT_EQ(
      run_program("sweep --quiet " + matrix() + " --trials " + path("rates/trials")).exit_code, 0);
  fs::remove(file("rates/trials/b~4/seed-1.jsonl"));
  ASSERT_EQ(submit("--resume --out " + path("rates")).exit_code, 0);
  EXPECT_THAT(read("rates.submit/jobs.json"), HasSubstr("\"shares\": \"2\""));
  EXPECT_THAT(read("rates.submit/sweep-1.sbatch"), HasSubstr("#SBATCH --array=2\n"));
  EXPECT_THAT(read("rates.submit/collect.sbatch"), HasSubstr(" --collect "));
}

TEST_F(SubmittedSweep, IsRefusedWithOptionsThatTheEngineHasNoUseFor) {
  const StandIns programs;
  programs.add_slurm();
  const std::string engine_of = "--dry-run --out " + path("out") + " --engine ";
  for (const std::string option : {"--throttle 2", "--max-array 9", "--time-min 5", "--memory 900",
                                   "--sbatch-option=--hold"}) {
    for (const std::string engine : {"parallel", "local"}) {
      const ProgramResult result = submit(engine_of + engine + " " + option);
      EXPECT_EQ(result.exit_code, 2) << option;
      EXPECT_THAT(result.err, HasSubstr(option.substr(0, option.find_first_of(" =")) +
                                        ": the engine " + engine + " has no use for it"));
    }
    EXPECT_EQ(submit(engine_of + "slurm " + option).exit_code, 0) << option;
  }
  EXPECT_EQ(submit(engine_of + "local --shards 3").exit_code, 2);
  EXPECT_EQ(submit(engine_of + "parallel --shards 3").exit_code, 0);
}

TEST_F(SubmittedSweep, LeavesNothingWhereItsEngineIsNotInstalled) {
  const ProgramResult result = run_program(
      "submit --sweep " + matrix() + " --out " + path("out") + " --engine parallel", "PATH=/none ");
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("parallel is not in PATH"));
  EXPECT_FALSE(exists("out"));
  EXPECT_FALSE(exists("out.submit"));
}

TEST_F(SubmittedSweep, IsTheOnlyWorkOfItsSubmit) {
  const std::string out = " --dry-run --out " + path("out");
  const std::string set = " --set odometry.preset=paper";
  const std::vector<std::string> refused{"submit --sweep " + path("scenarios"),
                                         "submit --test " + path("scenarios") + set,
                                         "submit spec.toml" + set,
                                         "submit spec.toml --sweep " + path("scenarios") + set,
                                         "submit spec.toml --seeds 3",
                                         "submit --sweep " + path("scenarios") + set + " --slow",
                                         "submit"};
  for (const std::string& words : refused) {
    EXPECT_EQ(run_program(words + out).exit_code, 2) << words;
  }
}

}  // namespace
