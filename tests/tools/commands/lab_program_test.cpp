#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"
#include "tests/support/small_forest.h"
#include "vo/files/output.h"
#include "vo/structured_forest/structured_forest_file.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;
using testing::Not;

/// A small scenario that passes, and a cache of its own.
class LabProgram : public support::ProgramTest {
 protected:
  LabProgram() : good_(write_scenario("good", "0.5")) {}

  ProgramResult test(const std::string& rest) const {
    return run_program("test --quiet --cache " + path("cache") + " " + rest);
  }

  void write_bad() const { write_scenario("bad", "1e-9"); }

  /// The only sequence of the cache.
  fs::path cached_sequence() const {
    for (const auto& entry : fs::directory_iterator(file("cache/sequences"))) {
      if (entry.is_directory()) {
        return entry.path();
      }
    }
    return {};
  }

  fs::path good_;
};

TEST_F(LabProgram, FailuresAreNamedAndTheOtherScenariosStillRun) {
  write_bad();
  write_scenario("odd", "1\n[sensor]\nexposre = 1");
  std::string no_scene = read("scenarios/good.toml");
  no_scene.replace(no_scene.find("room/room"), 9, "room/none");
  write("scenarios/lost.toml", no_scene);
  const ProgramResult result =
      test(path("scenarios") + " --json " + path("r.json") + " --junit " + path("r.xml"));
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.out, HasSubstr("bad: ate_rmse_m is "));
  EXPECT_THAT(result.out, HasSubstr("expected <= 1e-09\n  it holds: it is broken\n"));
  EXPECT_THAT(result.out, HasSubstr("unknown key 'sensor.exposre'; the nearest known key is "
                                    "sensor.exposure"));
  EXPECT_THAT(result.out, HasSubstr("none.gltf: there is no such file"));
  EXPECT_THAT(result.out, HasSubstr("FAIL  4 scenarios, 1 within their bounds, 1 FAILED, 2 not "
                                    "measured"));
  const json results = json::parse(read("r.json"));
  EXPECT_EQ(results["schema"], "edvo.results");
  EXPECT_EQ(results["schema_version"], 1);
  EXPECT_EQ(results["scenarios"].size(), 4U);
  EXPECT_EQ(results["passed"], false);
  EXPECT_THAT(read("r.xml"), HasSubstr("tests=\"4\" failures=\"1\" errors=\"2\""));
}

TEST_F(LabProgram, WhatWasMeasuredIsKeptForThisProgram) {
  const ProgramResult cold = test(path("scenarios") + " --json " + path("cold.json"));
  EXPECT_EQ(cold.exit_code, 0) << cold.out << cold.err;
  EXPECT_THAT(cold.out, Not(HasSubstr("kept")));
  const ProgramResult warm = test(path("scenarios") + " --json " + path("warm.json"));
  EXPECT_EQ(warm.exit_code, 0);
  EXPECT_THAT(warm.out, HasSubstr("kept"));
  const ProgramResult again = test(path("scenarios") + " --again --json " + path("again.json"));
  EXPECT_THAT(again.out, Not(HasSubstr("kept")));
  EXPECT_EQ(read("cold.json"), read("warm.json"));
  EXPECT_EQ(read("cold.json"), read("again.json"));
}

TEST_F(LabProgram, ABrokenCacheEntryIsFoundSaidAndMadeAgain) {
  const ProgramResult first = test(path("scenarios/good.toml") + " --json " + path("a.json"));
  ASSERT_EQ(first.exit_code, 0) << first.out;
  const fs::path image = cached_sequence() / "rgb/000002.png";
  std::ofstream(image, std::ios::binary | std::ios::in | std::ios::out).seekp(100).put('!');
  const ProgramResult second = test(path("scenarios/good.toml") + " --json " + path("b.json"));
  EXPECT_EQ(second.exit_code, 0) << second.out;
  EXPECT_THAT(second.out, HasSubstr("was rendered again: rgb/000002.png has other bytes than were "
                                    "written"));
  EXPECT_EQ(read("a.json"), read("b.json"));
}

TEST_F(LabProgram, TheCacheIsListedVerifiedAndPruned) {
  ASSERT_EQ(test(path("scenarios/good.toml")).exit_code, 0);
  const std::string cache = " --cache " + path("cache");
  EXPECT_THAT(run_program("cache list" + cache).out, HasSubstr("room.gltf"));
  EXPECT_THAT(run_program("cache verify" + cache).out, HasSubstr("of which 0 were broken"));
  fs::remove(cached_sequence() / "rgb/000001.png");
  EXPECT_THAT(run_program("cache verify" + cache).out, HasSubstr("rgb/000001.png is missing"));
  EXPECT_EQ(cached_sequence(), fs::path());
  ASSERT_EQ(test(path("scenarios/good.toml") + " --again").exit_code, 0);
  EXPECT_THAT(run_program("cache prune --max-size 1G" + cache).out, HasSubstr("0 sequences"));
  EXPECT_THAT(run_program("cache prune --max-size 1k" + cache).out, HasSubstr("1 sequences"));
  EXPECT_EQ(cached_sequence(), fs::path());
  EXPECT_EQ(run_program("cache prune --max-size many" + cache).exit_code, 2);
}

TEST_F(LabProgram, ASequenceIsKeptForWhatOfTheFileIsPlayed) {
  std::string still = read("scenarios/good.toml");
  still.insert(still.find("[camera]"), "animation = \"none\"\n");
  write("scenarios/still.toml", still);
  ASSERT_EQ(test(path("scenarios")).exit_code, 0);
  EXPECT_THAT(run_program("cache list --cache " + path("cache")).out, HasSubstr("2 sequences"));
}

TEST_F(LabProgram, TwoRunsShareACache) {
  ProgramResult other;
  std::thread thread(
      [&] { other = test(path("scenarios/good.toml") + " --json " + path("1.json")); });
  const ProgramResult result = test(path("scenarios/good.toml") + " --json " + path("2.json"));
  thread.join();
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(other.exit_code, 0) << other.out << other.err;
  EXPECT_EQ(read("1.json"), read("2.json"));
  EXPECT_FALSE(support::has_leftovers(file("cache/sequences")));
}

TEST_F(LabProgram, AFullDiskIsTemporaryAndTheNextRunGoesOn) {
  fs::create_directory(file("cache"));
  write("twice.sh", "mount -t tmpfs -o size=64k none " + path("cache") +
                        " 2>/dev/null || exit 77\n" + "\"$@\"; echo first $?\n" +
                        "mount -o remount,size=64m " + path("cache") + "; exec \"$@\"\n");
  const ProgramResult result =
      run_program("test --quiet --cache " + path("cache") + " " + path("scenarios") + " --json " +
                      path("r.json"),
                  "unshare --map-root-user --mount sh " + path("twice.sh") + " ");
  if (result.exit_code == 77 || result.err.find("unshare") != std::string::npos) {
    GTEST_SKIP() << "a disk of limited size needs namespaces of users, which are not permitted";
  }
  EXPECT_THAT(result.out, HasSubstr("good: "));
  EXPECT_THAT(result.out, HasSubstr("No space left on device; finished frames are kept in "));
  EXPECT_THAT(result.out, HasSubstr("first 75\n"));
  EXPECT_THAT(result.out, HasSubstr("PASS  1 scenarios")) << result.err;
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(json::parse(read("r.json"))["passed"], true);
}

TEST_F(LabProgram, AChangeOfTheBaselineIsAViolation) {
  const std::string options = path("scenarios/good.toml") + " --baseline " + path("base.json");
  EXPECT_EQ(test(options).exit_code, 3) << "there is none";
  ASSERT_EQ(test(options + " --update-baseline").exit_code, 0);
  EXPECT_EQ(test(options).exit_code, 0) << "the same build";
  const ProgramResult paper = test(options + " --tracker \"'" EDVO_PROGRAM
                                             "' track {sequence} --preset paper --quiet --set "
                                             "align.max_iterations=1 --out {output}\"");
  EXPECT_EQ(paper.exit_code, 4) << paper.out;
  EXPECT_THAT(paper.out, HasSubstr("good: ate_rmse_m was "));
  EXPECT_THAT(paper.out, HasSubstr("CHANGED"));
}

TEST_F(LabProgram, AForestModelIsPartOfWhatWasMeasured) {
  write("forest.yml",
        vo::structured_forest_yaml(support::small_forest(0, 0.5F, support::all_bins())));
  const std::string name = fs::absolute(file("forest.yml")).string();
  write("scenarios/good.toml", read("scenarios/good.toml") +
                                   "\n[odometry]\ntracker.edges.detector = \"structured_forest\"\n"
                                   "tracker.edges.forest_model = \"" +
                                   name + "\"\n");
  const std::string options = path("scenarios/good.toml") + " --bounds none";
  const ProgramResult first = test(options);
  ASSERT_EQ(first.exit_code, 0) << first.out << first.err;
  EXPECT_EQ(test(options).exit_code, 0) << "it is kept";
  fs::remove(file("forest.yml"));
  const ProgramResult gone = test(options);
  EXPECT_EQ(gone.exit_code, 3) << gone.out;
  EXPECT_THAT(gone.out, HasSubstr("forest.yml"));
}

TEST_F(LabProgram, ScenariosOfOneNameAreRefused) {
  write("others/good.toml", read("scenarios/good.toml"));
  const std::string scenarios = path("scenarios/good.toml") + " " + path("others/good.toml");
  for (const std::string& line :
       {"test " + scenarios, "sweep " + scenarios + " --set path.rate=5,6 --out " + path("s")}) {
    const ProgramResult result = run_program(line);
    EXPECT_EQ(result.exit_code, 2) << line << result.err;
    EXPECT_THAT(result.err, HasSubstr("others/good.toml: has the name of "));
    EXPECT_THAT(result.err, HasSubstr("scenarios/good.toml"));
  }
  EXPECT_FALSE(exists("s"));
  EXPECT_EQ(
      test(path("scenarios/good.toml") + " " + path("scenarios/../scenarios/good.toml")).exit_code,
      0)
      << "one file twice";
}

TEST_F(LabProgram, OptionsOfATrackerNeedOne) {
  for (const std::string options : {"--tracker ''", "--time-limit 5"}) {
    const ProgramResult result = test(path("scenarios/good.toml") + " " + options);
    EXPECT_EQ(result.exit_code, 2) << options << result.out;
    EXPECT_EQ(result.out, "") << options;
  }
}

TEST_F(LabProgram, AnOutsideTrackerIsJudgedByTheSameBounds) {
  const ProgramResult same = test(path("scenarios/good.toml") + " --json " + path("own.json"));
  ASSERT_EQ(same.exit_code, 0);
  const ProgramResult outside =
      test(path("scenarios/good.toml") + " --json " + path("outside.json") + " --tracker \"'" +
           EDVO_PROGRAM "' track {sequence} --camera {camera} --out {output}\"");
  EXPECT_EQ(outside.exit_code, 0) << outside.out;
  const auto ate = [&](const char* file) {
    return json::parse(read(file))["scenarios"][0]["metrics"]["ate_rmse_m"]["mean"].get<double>();
  };
  EXPECT_NEAR(ate("own.json"), ate("outside.json"), 1e-6) << "nine decimals in the file";
  const ProgramResult broken = test(path("scenarios") + " --tracker 'true {sequence} {output}'");
  EXPECT_EQ(broken.exit_code, 4);
  EXPECT_THAT(broken.out, HasSubstr("good: the tracker wrote no trajectory to {output}"));
}

TEST_F(LabProgram, BytesThatATrackerPrintsDoNotBreakTheResults) {
  const ProgramResult result =
      test(path("scenarios") + " --json " + path("r.json") + " --junit " + path("r.xml") +
           " --report " + path("r.html") + R"( --tracker "printf '\\377<\\001'")");
  EXPECT_EQ(result.exit_code, 4) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("it last said: ?<?\n"));
  EXPECT_EQ(json::parse(read("r.json"))["scenarios"].size(), 1U);
  EXPECT_THAT(read("r.xml"), HasSubstr("it last said: ?&lt;?\""));
  EXPECT_THAT(read("r.html"), HasSubstr("it last said: ?"));
}

TEST_F(LabProgram, OneReportShowsEveryScenario) {
  write_bad();
  write_scenario("odd", "1\n[sensor]\nexposre = 1");
  const ProgramResult result = test(path("scenarios") + " --seeds 2 --report " + path("r.html"));
  EXPECT_EQ(result.exit_code, 3) << result.out << result.err;
  const std::string html = read("r.html");
  EXPECT_THAT(html, HasSubstr("<title>edvo report: 1 of 3 scenarios passed</title>"));
  EXPECT_THAT(html, HasSubstr("metrics are means over 2 seeds"));
  EXPECT_THAT(html, HasSubstr("unknown key 'sensor.exposre'"));
  EXPECT_EQ(test(path("scenarios/good.toml") + " --report " + path("none/r.html")).exit_code, 3)
      << "found before anything is rendered";
}

#ifdef EDVO_OPENCV_TRACKER
TEST_F(LabProgram, OpencvsOdometryIsTestedAsAnOutsideTracker) {
  const ProgramResult result = test(path("scenarios") + " --tracker \"'" EDVO_OPENCV_TRACKER
                                                        "' {sequence} {camera} {output}\"");
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}
#endif

TEST_F(LabProgram, ResultsAreComparedSideBySide) {
  ASSERT_EQ(test(path("scenarios/good.toml") + " --json " + path("a.json")).exit_code, 0);
  const std::string a = path("a.json");
  const ProgramResult same = run_program("compare " + a + " " + a);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("metrics are the same within chance"));
  std::string changed = read("a.json");
  const std::string key = "\"ate_rmse_m\": ";
  const std::size_t at = changed.rfind(key) + key.size();
  changed.replace(at, changed.find(',', at) - at, "0.4");
  write("b.json", changed);
  const ProgramResult worse = run_program("compare " + a + " " + path("b.json"));
  EXPECT_EQ(worse.exit_code, 4) << worse.err;
  EXPECT_THAT(worse.out, HasSubstr("ALARM: worse"));
  write("c.json", "{}");
  EXPECT_EQ(run_program("compare " + a + " " + path("c.json")).exit_code, 3);
  EXPECT_EQ(run_program("compare " + a).exit_code, 2);
}

TEST_F(LabProgram, BuildsAreComparedByWhatTheyMeasure) {
  const std::string cache = "export XDG_CACHE_HOME=" + path("") + "; ";
  const fs::path worse = write("worse", std::string("#!/bin/sh\nexec '") + EDVO_PROGRAM +
                                            "' \"$@\" --tracker \"'" EDVO_PROGRAM
                                            "' track {sequence} --preset paper --quiet"
                                            " --set align.max_iterations=1 --out {output}\"\n");
  fs::permissions(worse, fs::perms::owner_all);
  const auto compare = [&](const std::string& build_b) {
    return run_program(
        "compare --build-a '" EDVO_PROGRAM "' --build-b " + build_b + " " + path("scenarios"),
        cache);
  };
  EXPECT_EQ(compare("'" EDVO_PROGRAM "'").exit_code, 0);
  const ProgramResult found = compare(path("worse"));
  EXPECT_EQ(found.exit_code, 4) << found.err;
  EXPECT_THAT(found.out, HasSubstr("ALARM: worse"));
  EXPECT_EQ(compare("/bin/true").exit_code, 3);
  EXPECT_EQ(compare("no_such_build").exit_code, 3);
}

TEST_F(LabProgram, AResultIsComparedWithItself) {
  ASSERT_EQ(test(path("scenarios") + " --seeds 4 --json " + path("a.json")).exit_code, 0);
  const ProgramResult result = run_program("compare --halves 50 " + path("a.json"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("0 of 50 comparisons with itself raise an alarm, 0.5 are"))
      << "no noise, no difference";
  EXPECT_EQ(run_program("compare --halves 50").exit_code, 2);
}

/// The rows of a CSV file without quotes, the first one its titles.
std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

TEST_F(LabProgram, SharesOfABudgetSumToTheWhole) {
  const std::string arguments = "budget " + path("scenarios/good.toml") + " --quiet --cache " +
                                path("cache") + " --seeds 1 --out " + path("budget");
  EXPECT_THAT(run_program(arguments).err, HasSubstr("its camera is perfect"));
  const ProgramResult result =
      run_program(arguments +
                  " --set sensor.max_depth=2 --set camera.distortion.k1=-0.1 --set "
                  "odometry.tracker.lens=ignore");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("causes most of the ATE"));
  double shares = 0;
  double whole = 0;
  for (const std::vector<std::string>& row : rows_of(read("budget/budget.csv"))) {
    if (row[0] == "ate_mm") {
      (row[1] == "all" ? whole : shares) += std::stod(row[4]);
    }
  }
  EXPECT_GT(whole, 0);
  EXPECT_NEAR(shares, whole, 1e-9);
}

TEST_F(LabProgram, ABasinIsDeepAtTheTruth) {
  const ProgramResult result = run_program(
      "basin " + path("scenarios/good.toml") + " --quiet --cache " + path("cache") +
      " --steps 3 --pairs 3 --max-translation 1 --max-rotation-deg 60 --out " + path("basin"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto rows = rows_of(read("basin/basin.csv"));
  ASSERT_EQ(rows.size(), 10U) << "titles and nine cells";
  EXPECT_EQ(rows[1][2], "100") << "from the truth itself";
  EXPECT_EQ(rows[9][2], "0") << "a metre and 60 deg off";
  EXPECT_THAT(read("basin/basin.svg"), HasSubstr("median position error, mm"));
}

TEST_F(LabProgram, ABasinOfAMonocularScenarioIsRefused) {
  const ProgramResult result = run_program("basin " + path("scenarios/good.toml") +
                                           " --quiet --set odometry.mode=mono --cache " +
                                           path("cache") + " --out " + path("basin"));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("odometry.mode is \"mono\", expected \"rgbd\""));
  EXPECT_FALSE(exists("basin"));
}

TEST_F(LabProgram, ASweepKeepsListsTogetherAndTellsMedians) {
  const ProgramResult result = run_program(
      "sweep " + path("scenarios/good.toml") + " --quiet --cache " + path("cache") +
      " --seeds 2 --set 'sensor.noise.full_well=[6000,6000,6000],[900,900,900]' --out " +
      path("noise"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto rows = rows_of(read("noise/sweep.csv"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[2][1], "900 900 900");
  EXPECT_THAT(read("noise/sweep.md"), HasSubstr("Medians full_well=900,900,900; ate_mm "));
}

TEST_F(LabProgram, ASweepHasARowPerCombination) {
  const std::string arguments = "sweep " + path("scenarios/good.toml") + " --quiet --cache " +
                                path("cache") + " --out " + path("sweep");
  const ProgramResult result = run_program(arguments +
                                           " --set odometry.preset=paper,default --set "
                                           "odometry.tracker.pyramid.levels=2,3");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto rows = rows_of(read("sweep/sweep.csv"));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[2][1] + rows[2][2], "paper3");
  EXPECT_NE(rows[1][3], rows[3][3]) << "another tracker has another error";
  EXPECT_THAT(read("sweep/sweep.md"), testing::Not(HasSubstr("Medians")));
  EXPECT_EQ(run_program(arguments + " --set odometry.prest=paper").exit_code, 2);
  EXPECT_EQ(run_program(arguments + " --set odometry.preset=best").exit_code, 2);
}

}  // namespace
