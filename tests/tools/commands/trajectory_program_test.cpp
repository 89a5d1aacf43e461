#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/example_trajectory.h"
#include "tests/support/pose_near.h"
#include "tests/support/program_test.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

using nlohmann::json;
using support::PoseNear;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

constexpr support::PoseTolerance kRounding{.translation_m = 1e-8, .rotation_deg = 1e-6};

/// A true trajectory, gt.txt, and an estimate that drifts from it, e.txt.
class Trajectories : public support::ProgramTest {
 protected:
  Trajectories() {
    vo::Vector6d velocity;
    velocity << 0.01, 0, 0, 0, 0.002, 0;
    write("gt.txt", vo::format_trajectory(truth));
    write("e.txt", vo::format_trajectory(support::drifting(truth, velocity)));
  }

  json evaluated(const std::string& arguments) const {
    const ProgramResult result = run_program("evaluate " + arguments + " --json --quiet");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? json::parse(result.out) : json();
  }

  ProgramResult convert(const std::string& from, const std::string& to,
                        const std::string& rest) const {
    return run_program("convert " + path(from) + " " + path(to) + " " + rest);
  }

  vo::Trajectory truth = support::example_trajectory(60, 30, 1305031102.0);
};

TEST_F(Trajectories, AnEstimateHasTheSameErrorsInEachFormat) {
  const json expected = evaluated(path("gt.txt") + " " + path("e.txt"));
  ASSERT_GT(expected["ate"]["rmse_m"], 1e-4);
  ASSERT_EQ(convert("e.txt", "e.csv", "--format euroc").exit_code, 0);
  ASSERT_EQ(convert("e.txt", "k.txt", "--format kitti").exit_code, 0);
  const json euroc = evaluated(path("gt.txt") + " " + path("e.csv"));
  const json kitti =
      evaluated(path("gt.txt") + " " + path("k.txt") + " --times " + path("k_times.txt"));
  EXPECT_EQ(euroc["estimate_format"], "euroc");
  EXPECT_EQ(kitti["estimate_format"], "kitti");
  for (const json& errors : {euroc, kitti}) {
    EXPECT_NEAR(errors["ate"]["rmse_m"], expected["ate"]["rmse_m"], 1e-8);
    EXPECT_NEAR(errors["rpe"]["rotation_rmse_deg"], expected["rpe"]["rotation_rmse_deg"], 1e-6);
    EXPECT_EQ(errors["matched"], 60);
  }
}

TEST_F(Trajectories, TwoFormatsAreInsistedOnWithACommaBetween) {
  ASSERT_EQ(convert("e.txt", "k.txt", "--format kitti").exit_code, 0);
  const std::string files =
      path("gt.txt") + " " + path("k.txt") + " --times " + path("k_times.txt");
  EXPECT_EQ(evaluated(files + " --format tum,kitti")["truth_format"], "tum");
  const ProgramResult one = run_program("evaluate " + files + " --format kitti");
  EXPECT_EQ(one.exit_code, 3);
  EXPECT_THAT(one.err, HasSubstr("gt.txt:2: expected 12 values"));
  EXPECT_EQ(run_program("evaluate " + files + " --format tum,kitti,tum").exit_code, 2);
  EXPECT_EQ(run_program("evaluate " + files + " --format kity").exit_code, 2);
}

TEST_F(Trajectories, APoseThatIsThereTwiceIsANoteAndChangesNothing) {
  const json expected = evaluated(path("gt.txt") + " " + path("e.txt"));
  const std::string text = read("gt.txt");
  const std::string last = text.substr(text.rfind('\n', text.size() - 2) + 1);
  write("twice.txt", text + last.substr(0, last.find(' ')) + " 9 9 9 0 0 0 1\n");
  const json errors = evaluated(path("twice.txt") + " " + path("e.txt"));
  EXPECT_EQ(errors["ate"], expected["ate"]);
  ASSERT_EQ(errors["notes"].size(), 1U);
  EXPECT_THAT(errors["notes"][0], HasSubstr("1 of 61 poses have the stamp of another"));
  EXPECT_THAT(run_program("evaluate " + path("twice.txt") + " " + path("e.txt")).out,
              HasSubstr("\nnote                 "));
}

TEST_F(Trajectories, ConvertGoesThereAndBack) {
  ASSERT_EQ(convert("gt.txt", "k.txt", "--format kitti").exit_code, 0);
  const ProgramResult result =
      convert("k.txt", "back.txt", "--format tum --json --times " + path("k_times.txt"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json document = json::parse(result.out);
  EXPECT_EQ(document["from"], "kitti");
  EXPECT_EQ(document["poses"], 60);
  const vo::Trajectory back = vo::read_trajectory(file("back.txt"));
  ASSERT_EQ(back.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(back[i].timestamp, truth[i].timestamp, 1e-6);
    EXPECT_THAT(back[i].T_world_camera, PoseNear(truth[i].T_world_camera, kRounding));
  }
}

TEST_F(Trajectories, ConvertReplacesNothingWithoutBeingTold) {
  write("k_times.txt", "mine\n");
  EXPECT_EQ(convert("gt.txt", "k.txt", "--format kitti").exit_code, 6);
  EXPECT_FALSE(exists("k.txt")) << "neither of the two is written";
  EXPECT_EQ(read("k_times.txt"), "mine\n");
  EXPECT_EQ(convert("gt.txt", "k.txt", "--format kitti --force").exit_code, 0);
  const ProgramResult sequence = convert("gt.txt", "s", "--format icl-nuim");
  EXPECT_EQ(sequence.exit_code, 2);
  EXPECT_THAT(sequence.err, HasSubstr("expected one of tum, euroc, kitti, got 'icl-nuim'"));
}

}  // namespace
