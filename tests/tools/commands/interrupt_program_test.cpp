#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/program_test.h"

namespace {

using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

class InterruptProgram : public support::ProgramTest {};

/// Returns results of four seeds.
std::string four_seeds() {
  std::string trials;
  for (const std::string seed : {"0", "1", "2", "3"}) {
    trials += (trials.empty() ? "" : ",") + (R"({"seed": )" + seed) + R"(, "sequence": "s)" + seed +
              R"(", "frames": 9, "metrics": {"ate_rmse_m": 0.0)" + seed + "1}}";
  }
  return R"({"schema": "edvo.results", "schema_version": 1, "scenarios": [{"name": "a", )"
         R"("trials": [)" +
         trials + "]}]}";
}

TEST_F(InterruptProgram, EndsMeasurementsOfNoise) {
  const ProgramResult result =
      run_program("sensor-check --quiet --frames 100000 --out " + path("check"),
                  "timeout --preserve-status -s INT 1 ");
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_FALSE(exists("check"));
}

TEST_F(InterruptProgram, EndsComparisonsOfHalves) {
  write("results.json", four_seeds());
  const ProgramResult result = run_program("compare --halves 1000000 " + path("results.json"),
                                           "timeout --preserve-status -s TERM 1 ");
  EXPECT_EQ(result.exit_code, 75) << result.err;
}

TEST_F(InterruptProgram, StepsWithoutEndAreRefused) {
  write("results.json", four_seeds());
  for (const std::string& line : {"sensor-check --frames 100001 --out " + path("check"),
                                  "compare --halves 1000001 " + path("results.json"),
                                  "sensor-check --frames 1 --size 3277x100 --out " + path("check"),
                                  "sensor-check --frames 1 --size 3x3 --out " + path("check")}) {
    const ProgramResult result = run_program(line);
    EXPECT_EQ(result.exit_code, 2) << line << result.err;
    EXPECT_THAT(result.err, HasSubstr("expected ")) << line;
  }
  EXPECT_FALSE(exists("check"));
}

}  // namespace
