#include "tools/outside_tracker/outside_tracker.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/folder_contents.h"
#include "tests/support/plane_sequence.h"
#include "tests/support/temp_folder.h"
#include "tools/processes/shell_words.h"
#include "vo/files/output.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::HasSubstr;

/// The command that has a shell run a script.
std::string shell(const std::string& script) {
  return "sh -c " + tools::shell_quoted(script);
}

/// A sequence of six frames and a tracker on it.
class OutsideTracker : public testing::Test {
 protected:
  OutsideTracker() { truth_ = support::write_plane_sequence(path(), 6); }

  std::filesystem::path path() const { return folder_.path() / "a $(touch here) 'sequence'"; }

  tools::OutsideRun run(const std::string& command, const tools::TrackerLimits& limits = {}) const {
    return tools::track_outside({.command = command, .limits = limits}, path(), content_,
                                vo::SequenceReader(path()), [] {});
  }

  tools::OutsideRun run_script(const std::string& script,
                               const tools::TrackerLimits& limits = {}) const {
    return run(shell(script), limits);
  }

  std::string error(const std::string& script) const { return run_script(script).problem; }

  /// Returns what a script prints last.
  std::string said(const std::string& script) const {
    const std::string text = error(script + "; exit 1");
    return text.substr(text.find("last said: ") + 11);
  }

  TempFolder folder_;
  vo::Trajectory truth_;
  vo::SequenceContent content_ = vo::SequenceContent::colour_and_depth;
};

/// Returns the trajectory with a millimetre added to and taken from every second position.
vo::Trajectory with_errors(vo::Trajectory trajectory) {
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const double error = i % 4 == 1 ? 0.001 : i % 4 == 3 ? -0.001 : 0;
    trajectory[i].T_world_camera =
        vo::SE3(Eigen::Quaterniond::Identity(), {0, error, 0}) * trajectory[i].T_world_camera;
  }
  return trajectory;
}

TEST_F(OutsideTracker, HasTheSameErrorsInWhateverWorldItIs) {
  const vo::Trajectory estimate = with_errors(truth_);
  vo::Trajectory moved = estimate;
  for (vo::StampedPose& pose : moved) {
    pose.T_world_camera =
        vo::SE3(Eigen::Quaterniond(0.6, 0, 0.8, 0), {1, 2, 3}) * pose.T_world_camera;
  }
  const std::string file = folder_.write("moved.txt", vo::format_trajectory(moved)).string();
  const tools::OutsideRun run = this->run("cp '" + file + "' {output}");
  EXPECT_EQ(run.problem, "");
  ASSERT_EQ(run.tracking.trajectory.size(), 6U);
  EXPECT_EQ(run.tracking.tracked_fraction(), 1);
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const Eigen::Vector3d difference = run.tracking.trajectory[i].T_world_camera.translation() -
                                       estimate[i].T_world_camera.translation();
    EXPECT_LT(difference.norm(), 1e-8) << "nine decimals of a metre";
  }
}

TEST_F(OutsideTracker, ThatHasTheTruthIsImplausible) {
  const std::string file = (path() / "groundtruth.txt").string();
  folder_.write("truth.txt", vo::read_file(file));
  const tools::OutsideRun run =
      this->run("cp '" + (folder_.path() / "truth.txt").string() + "' {output}");
  EXPECT_EQ(run.kind, tools::ProblemKind::implausible);
  EXPECT_THAT(run.problem, HasSubstr("is below the rounding of its own numbers"));
}

TEST_F(OutsideTracker, IsGivenTheCameraAndMaySayThatItWasLost) {
  const std::string file = folder_.write("truth.txt", vo::format_trajectory(truth_)).string();
  const vo::SequenceResult result =
      run_script("test -f \"$EDVO_CAMERA\" && head -4 '" + file + "' > \"$EDVO_OUTPUT\"; exit 5")
          .tracking;
  EXPECT_LT(result.tracked_fraction(), 1);
  EXPECT_EQ(result.frames.size(), 6U);
  EXPECT_EQ(result.frames.back().status, vo::TrackingStatus::lost);
}

TEST_F(OutsideTracker, MaySayThatItWasLostFromTheFirstFrameOn) {
  for (const char* script : {"exit 5", "echo '# no pose' > $EDVO_OUTPUT; exit 5"}) {
    const vo::SequenceResult result = run_script(script).tracking;
    EXPECT_EQ(result.frames.size(), 6U);
    EXPECT_EQ(result.tracked_fraction(), 0);
    EXPECT_TRUE(result.trajectory.empty());
  }
}

TEST_F(OutsideTracker, ThatFailsIsASentence) {
  EXPECT_THAT(error("kill -SEGV $$"), HasSubstr("the tracker crashed (signal 11)"));
  EXPECT_THAT(error("sh -c 'kill -ABRT $$'; exit $?"), HasSubstr("the tracker crashed (signal 6)"));
  EXPECT_THAT(error("echo no licence; exit 3"),
              HasSubstr("ended with exit code 3, expected 0; it last said: no licence"));
  EXPECT_THAT(run("no_such_program {sequence} {output}").problem,
              HasSubstr("no_such_program: cannot be started: "));
  EXPECT_THAT(error("true"), HasSubstr("wrote no trajectory"));
  EXPECT_THAT(error(": > $EDVO_OUTPUT"), HasSubstr("empty trajectory"));
  EXPECT_THAT(error("head -c 999 /dev/zero > $EDVO_OUTPUT; echo >> $EDVO_OUTPUT"),
              HasSubstr("the tracker's trajectory:1"));
  EXPECT_THAT(error("echo 0 1 2 3 0 0 0 nan > $EDVO_OUTPUT"),
              HasSubstr("the tracker's trajectory:1"));
  EXPECT_THAT(error("printf '0 0 0 0 0 0 0 1\\n0.03 0 0' > $EDVO_OUTPUT"),
              HasSubstr("ends within a line"));
  EXPECT_THAT(error("echo 100 0 0 0 0 0 0 1 > $EDVO_OUTPUT"),
              HasSubstr("no pose at the time of a frame"));
  EXPECT_THAT(error("ln -s /etc/passwd $EDVO_OUTPUT"), HasSubstr("made {output} no file"));
}

TEST_F(OutsideTracker, ThatFailsIsOfAKind) {
  EXPECT_EQ(run_script("kill -SEGV $$").kind, tools::ProblemKind::crash);
  EXPECT_EQ(run_script("sleep 60", {.time_limit = 0.1}).kind, tools::ProblemKind::timeout);
  EXPECT_EQ(run_script("exit 3").kind, tools::ProblemKind::tracker);
}

TEST_F(OutsideTracker, ThatHangsIsEndedAtItsTimeLimit) {
  EXPECT_EQ(run_script("echo busy; sleep 60", {.time_limit = 0.2}).problem,
            "the tracker was ended after 0.2 s, its time limit; it last said: busy");
}

TEST_F(OutsideTracker, ThatTakesTooMuchIsEnded) {
  EXPECT_THAT(run_script("yes", {.output_limit = 1}).problem,
              HasSubstr("printing more than 1 MB (--output-limit); it last said: y"));
  EXPECT_THAT(run_script("for i in 1 2 3 4 5 6 7 8; do sleep 60 & done; wait", {.process_limit = 6})
                  .problem,
              HasSubstr("running more than 6 processes (--process-limit)"));
  EXPECT_THAT(run_script("exec python3 -c 'import time; x = bytearray(30000000); time.sleep(60)'",
                         {.memory_limit = 20})
                  .problem,
              HasSubstr("holding more than 20 MB of memory (--memory-limit)"));
  EXPECT_THAT(run_script("exec head -c 3m /dev/zero > file", {.file_limit = 2}).problem,
              HasSubstr("wrote a file of more than 2 MB (--file-limit)"));
}

TEST_F(OutsideTracker, IsStartedFromWordsAndToldOfPlacesInItsEnvironment) {
  const std::filesystem::path mark = folder_.path() / "told";
  const std::string script =
      folder_
          .write("tell.sh", "echo \"$1\" > '" + mark.string() + "'\necho \"$EDVO_SEQUENCE\" >> '" +
                                mark.string() + "'\n")
          .string();
  run("sh '" + script + "' '{sequence}/$(touch {camera})' {output}");
  const std::string told = vo::read_file(mark);
  const std::string sequence = told.substr(told.find('\n') + 1);
  EXPECT_EQ(told, sequence.substr(0, sequence.size() - 1) + "/$(touch " +
                      sequence.substr(0, sequence.size() - 1) + "/camera.toml)\n" + sequence);
}

TEST_F(OutsideTracker, IsNotToldWhereTheTruthIs) {
  const std::filesystem::path mark = folder_.path() / "environment";
  const std::filesystem::path withheld = folder_.path() / "cache/edvo";
  setenv("XDG_CACHE_HOME", withheld.parent_path().c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  setenv("TOLD", withheld.c_str(), 1);                          // NOLINT(concurrency-mt-unsafe)
  tools::track_outside({.command = shell("env > '" + mark.string() + "'"), .withheld = withheld},
                       path(), content_, vo::SequenceReader(path()), [] {});
  unsetenv("XDG_CACHE_HOME");  // NOLINT(concurrency-mt-unsafe)
  unsetenv("TOLD");            // NOLINT(concurrency-mt-unsafe)
  EXPECT_THAT(vo::read_file(mark), HasSubstr("EDVO_OUTPUT="));
  EXPECT_THAT(vo::read_file(mark), testing::Not(HasSubstr((folder_.path() / "cache").string())));
}

TEST_F(OutsideTracker, SeesImagesCameraAndImuAlone) {
  for (const char* name : {"sequence.toml", "truth/flow.npy", "depth_float/000000.npy"}) {
    vo::write_files(path(), {{name, "truth"}});
  }
  vo::write_files(path(), {{"imu.csv", "0"}, {"imu.toml", ""}});
  const char* script = "cd \"$EDVO_SEQUENCE\"; echo $(find . -type f | grep -v 00000[1-5] | sort)";
  EXPECT_EQ(said(script),
            "./camera.toml ./depth.txt ./depth/000000.png ./imu.csv ./imu.toml "
            "./rgb.txt ./rgb/000000.png");
  content_ = vo::SequenceContent::colour;
  EXPECT_EQ(said(script), "./camera.toml ./imu.csv ./imu.toml ./rgb.txt ./rgb/000000.png");
}

TEST_F(OutsideTracker, ReadsTheBytesOfTheSequenceAndWritesNoneOfThem) {
  const auto before = support::contents(path());
  EXPECT_EQ(
      said("sha256sum < \"$EDVO_SEQUENCE/rgb/000003.png\""),
      said("sha256sum < '/" + folder_.write("copy", before.at("rgb/000003.png")).string() + "'"));
  error("cd \"$EDVO_SEQUENCE\"; chmod -R u+w .; echo x > rgb/000000.png; rm -rf *; echo x > more");
  EXPECT_EQ(support::contents(path()), before);
}

TEST_F(OutsideTracker, CannotWriteItsInput) {
  EXPECT_THAT(said("cd \"$EDVO_SEQUENCE\" && echo x > rgb/000000.png"),
              HasSubstr("rgb/000000.png"));
  EXPECT_THAT(said("cd \"$EDVO_SEQUENCE\" && touch more && echo done"), HasSubstr("more"));
}

TEST_F(OutsideTracker, NeedsACommandThatSaysWhereWithoutAShell) {
  const auto usage = [](const std::string& command) {
    return error_text([&] { tools::OutsideTracker{.command = command}.validate(); });
  };
  EXPECT_THAT(usage("vo {sequence}"), HasSubstr("expected {output} or, in a script, $EDVO_OUTPUT"));
  EXPECT_THAT(
      usage("vo {sequence} > {output}"),
      HasSubstr("has an unquoted >, which only a shell understands; to use a shell write sh "
                "-c 'vo \"$EDVO_SEQUENCE\""));
  EXPECT_THAT(usage("sh -c 'vo {sequence} > {output}'"), HasSubstr("text of a script"));
  EXPECT_THAT(usage(" "), HasSubstr("expected a program"));
  for (const std::string command :
       {"vo {sequence} {output}", "sh -c 'vo \"$1\" >\"$2\"' sh {sequence} {output}",
        "sh -c \"vo <$EDVO_SEQUENCE >$EDVO_OUTPUT\"", "./a_script_that_reads_the_environment"}) {
    EXPECT_EQ(usage(command), "no error") << command;
  }
}

}  // namespace
