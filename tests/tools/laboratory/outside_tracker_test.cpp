#include "tools/laboratory/outside_tracker.h"

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/plane_sequence.h"
#include "tests/support/temp_folder.h"
#include "vo/dataset/trajectory_file.h"
#include "vo/files/output.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::HasSubstr;

/// A sequence of six frames and a tracker on it.
class OutsideTracker : public testing::Test {
 protected:
  OutsideTracker() { truth_ = support::write_plane_sequence(path(), 6); }

  std::filesystem::path path() const { return folder_.path() / "a sequence"; }

  tools::OutsideRun run(const std::string& command, double time_limit = 10) const {
    return tools::track_outside({.command = command, .time_limit = time_limit}, path(),
                                vo::SequenceReader(path()), [] {});
  }

  vo::SequenceResult track(const std::string& command) const { return run(command).tracking; }

  std::string error(const std::string& command, double time_limit = 10) const {
    return run(command, time_limit).problem;
  }

  TempFolder folder_;
  vo::Trajectory truth_;
};

TEST_F(OutsideTracker, ThatWritesTheTruthHasNoErrorInWhateverWorldItIs) {
  vo::Trajectory moved = truth_;
  for (vo::StampedPose& pose : moved) {
    pose.T_world_camera =
        vo::SE3(Eigen::Quaterniond(0.6, 0, 0.8, 0), {1, 2, 3}) * pose.T_world_camera;
  }
  vo::write_file(path() / "moved.txt", vo::format_trajectory(moved));
  const vo::SequenceResult result = track("cp {sequence}/moved.txt {output}");
  ASSERT_EQ(result.trajectory.size(), 6U);
  EXPECT_EQ(result.tracked_fraction(), 1);
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const Eigen::Vector3d difference =
        result.trajectory[i].T_world_camera.translation() - truth_[i].T_world_camera.translation();
    EXPECT_LT(difference.norm(), 1e-8) << "nine decimals of a metre";
  }
}

TEST_F(OutsideTracker, IsGivenTheCameraAndMaySayThatItWasLost) {
  const vo::SequenceResult result =
      track("test -f {camera} && head -4 {sequence}/groundtruth.txt > {output}; exit 5");
  EXPECT_LT(result.tracked_fraction(), 1);
  EXPECT_EQ(result.frames.size(), 6U);
  EXPECT_EQ(result.frames.back().status, vo::TrackingStatus::lost);
}

TEST_F(OutsideTracker, MaySayThatItWasLostFromTheFirstFrameOn) {
  for (const char* command : {"true {sequence} {output}; exit 5",
                              "true {sequence}; echo '# no pose' > {output}; exit 5"}) {
    const vo::SequenceResult result = track(command);
    EXPECT_EQ(result.frames.size(), 6U);
    EXPECT_EQ(result.tracked_fraction(), 0);
    EXPECT_TRUE(result.trajectory.empty());
  }
}

TEST_F(OutsideTracker, ThatFailsIsASentence) {
  EXPECT_THAT(error("echo {sequence} {output} >/dev/null; kill -SEGV $$"),
              HasSubstr("the tracker crashed (signal 11)"));
  EXPECT_THAT(error("sh -c 'kill -ABRT $$'; exit $? # {sequence} {output}"),
              HasSubstr("the tracker crashed (signal 6)"));
  EXPECT_THAT(error("echo no licence; exit 3 # {sequence} {output}"),
              HasSubstr("ended with exit code 3, expected 0; it last said: no licence"));
  EXPECT_THAT(error("no_such_program {sequence} {output}"), HasSubstr("exit code 127"));
  EXPECT_THAT(error("true {sequence} {output}"), HasSubstr("wrote no trajectory"));
  EXPECT_THAT(error("true {sequence}; : > {output}"), HasSubstr("empty trajectory"));
  EXPECT_THAT(error("true {sequence}; head -c 999 /dev/zero > {output}; echo >> {output}"),
              HasSubstr("the tracker's trajectory:1"));
  EXPECT_THAT(error("true {sequence}; echo 0 1 2 3 0 0 0 nan > {output}"),
              HasSubstr("the tracker's trajectory:1"));
  EXPECT_THAT(error("head -c 130 {sequence}/groundtruth.txt > {output}"),
              HasSubstr("ends within a line"));
  EXPECT_THAT(error("true {sequence}; echo 100 0 0 0 0 0 0 1 > {output}"),
              HasSubstr("no pose at the time of a frame"));
}

TEST_F(OutsideTracker, ThatFailsIsOfAKind) {
  EXPECT_EQ(run("kill -SEGV $$ # {sequence} {output}").kind, tools::ProblemKind::crash);
  EXPECT_EQ(run("sleep 60 # {sequence} {output}", 0.1).kind, tools::ProblemKind::timeout);
  EXPECT_EQ(run("exit 3 # {sequence} {output}").kind, tools::ProblemKind::tracker);
}

TEST_F(OutsideTracker, ThatHangsIsEndedWithAllItStarted) {
  const auto start = std::chrono::steady_clock::now();
  const std::string mark = (folder_.path() / "mark").string();
  EXPECT_THAT(error("(sleep 1; echo late > '" + mark + "') & sleep 60 # {sequence} {output}", 0.2),
              HasSubstr("was ended after 0.2 s, its time limit"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  EXPECT_FALSE(std::filesystem::exists(mark));
}

TEST_F(OutsideTracker, NeedsPlacesForSequenceAndOutput) {
  EXPECT_THAT(error_text([] { tools::OutsideTracker{.command = "vo {sequence}"}.validate(); }),
              HasSubstr("expected {output} in it"));
}

}  // namespace
