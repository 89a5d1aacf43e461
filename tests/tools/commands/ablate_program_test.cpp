#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/plane_sequence.h"
#include "tests/support/program_test.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

class AblateProgram : public support::ProgramTest {
 protected:
  AblateProgram() { support::write_plane_sequence(file("plane"), 9); }

  ProgramResult ablate(const std::string& study, const std::string& rest) const {
    return run_program("ablate " + path("plane") + " --quiet --study " + study + " --seeds 2 " +
                       rest);
  }

  std::string out(const std::string& name) const { return "--out " + path(name); }
};

/// The lines of a CSV without the columns whose title has this part.
std::vector<std::string> without_columns(const std::string& csv, const std::string& part) {
  std::istringstream lines(csv);
  std::vector<std::string> kept;
  std::vector<bool> is_kept;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::string result;
    std::size_t column = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++column) {
      if (kept.empty()) {
        is_kept.push_back(cell.find(part) == std::string::npos);
      }
      result += is_kept.at(column) ? cell + "," : "";
    }
    kept.push_back(result);
  }
  return kept;
}

TEST_F(AblateProgram, PointsComparesEdgesRandomAndAllPixels) {
  const ProgramResult result = ablate("points", "--json " + out("points"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  ASSERT_EQ(report["rows"].size(), 11U * 2 + 1);
  const json& edges = report["rows"][20];
  const json& random = report["rows"][21];
  const json& all = report["rows"][22];
  EXPECT_EQ(edges["selection"], "edges");
  EXPECT_EQ(edges["percent"], 100);
  EXPECT_EQ(edges["rpe_sd_mm"], 0) << "nothing about it is random";
  EXPECT_NEAR(double(edges["points"]), double(random["points"]), 0.05 * double(edges["points"]))
      << "as many, but for those that leave the image";
  EXPECT_NEAR(double(all["points"]), 160 * 120, 0.1 * 160 * 120);
  EXPECT_LT(double(edges["ate_mm"]), 2) << "of 40 mm";
  for (const char* name : {"points.csv", "points.svg", "points.md"}) {
    EXPECT_TRUE(exists(std::string("points/") + name)) << name;
  }
  EXPECT_THAT(read("points/points.md"), HasSubstr("edvo ablate plane --study points"));
}

TEST_F(AblateProgram, PointsRepeatsExactlyButForTimes) {
  ASSERT_EQ(ablate("points", out("first")).exit_code, 0);
  ASSERT_EQ(ablate("points", out("second")).exit_code, 0);
  EXPECT_EQ(without_columns(read("first/points.csv"), "ms_per_frame"),
            without_columns(read("second/points.csv"), "ms_per_frame"));
}

TEST_F(AblateProgram, StudiesWithoutTimesGiveTheSameBytes) {
  for (const char* study : {"residuals", "levels"}) {
    ASSERT_EQ(ablate(study, out("same")).exit_code, 0) << study;
    EXPECT_EQ(ablate(study, out("same")).exit_code, 0) << study << ": it would replace a result";
  }
  EXPECT_EQ(ablate("levels", "--max-error 0.001 " + out("same")).exit_code, 6);
}

TEST_F(AblateProgram, ResidualsFallWhenEdgesAreAligned) {
  const ProgramResult result = ablate("residuals", "--json " + out("residuals"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json rows = json::parse(result.out)["rows"];
  ASSERT_EQ(rows.size(), 5U);
  for (const json& row : rows) {
    EXPECT_LT(double(row["after_edges_grey"]), 0.5 * double(row["before_grey"]));
  }
  EXPECT_GT(double(rows[4]["before_grey"]), double(rows[0]["before_grey"])) << "it moves on";
  EXPECT_TRUE(exists("residuals/residuals.png"));
  EXPECT_TRUE(exists("residuals/residuals_histogram.csv"));
}

TEST_F(AblateProgram, LevelsCountsThePairsThatConverge) {
  const ProgramResult result = ablate("levels", "--json " + out("levels"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json rows = json::parse(result.out)["rows"];
  ASSERT_EQ(rows.size(), 4U * 6) << "1, 2, 4 and 8 of 9 frames apart";
  EXPECT_EQ(rows[0]["pairs"], 8);
  EXPECT_EQ(rows[2]["converged_percent"], 100) << "5 mm with three levels";
}

TEST_F(AblateProgram, TimeAndDetectorsSayWhatTheyMeasured) {
  const ProgramResult time = ablate("time", out("time"));
  EXPECT_EQ(time.exit_code, 0) << time.err;
  EXPECT_THAT(time.out, HasSubstr("R^2 = "));
  const ProgramResult detectors = ablate("detectors", out("detectors"));
  EXPECT_EQ(detectors.exit_code, 0) << detectors.err;
  EXPECT_THAT(detectors.out, HasSubstr("Canny, Otsu"));
  EXPECT_THAT(detectors.out, HasSubstr("keyframe every 4"));
}

TEST_F(AblateProgram, AWrongCommandLineIsUsage) {
  for (const char* arguments :
       {"ablate --out x", "ablate a --out x", "ablate a --study pionts --out x",
        "ablate a --study points", "ablate a --study points --pairs --out x",
        "ablate a --study points --seeds 0 --out x",
        "ablate a --study points --set points.fractoin=1 --out x",
        "ablate a --study points --set points.fraction=2 --out x"}) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments << "\n" << result.err;
    EXPECT_EQ(result.out, "") << arguments;
  }
}

TEST_F(AblateProgram, UnusableInputIsNamed) {
  const std::string never = " --study points --quiet " + out("never");
  EXPECT_THAT(run_program("ablate none" + never).err, HasSubstr("none: there is no such folder"));
  EXPECT_EQ(run_program("ablate none.toml" + never).exit_code, 3);
  fs::copy(file("plane"), file("blind"), fs::copy_options::recursive);
  fs::remove(file("blind/groundtruth.txt"));
  const ProgramResult blind = run_program("ablate " + path("blind") + never);
  EXPECT_EQ(blind.exit_code, 3);
  EXPECT_THAT(blind.err, HasSubstr("blind: has no groundtruth.txt"));
}

}  // namespace
