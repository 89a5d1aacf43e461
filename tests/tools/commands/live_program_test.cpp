#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/plane_sequence.h"
#include "tests/support/program_test.h"
#include "vo/files/input.h"

namespace {

using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;
using testing::MatchesRegex;

class LiveProgram : public support::ProgramTest {
 protected:
  void SetUp() override {
    support::write_plane_sequence(file("sequence"), 8);
    if (track("probe", "--live").exit_code == 2) {
      GTEST_SKIP() << "the program was built without an HTTP server";
    }
  }

  ProgramResult track(const std::string& name, const std::string& options,
                      const std::string& before = "") const {
    return run_program("track " + path("sequence") + " --quiet --out " + path(name + ".txt") +
                           " --frame-log " + path(name + ".csv") + " " + options,
                       before);
  }
};

TEST_F(LiveProgram, WritesTheSameBytesWithAndWithoutThePage) {
  for (const std::string mode : {"rgbd", "mono --bootstrap rgbd"}) {
    ASSERT_EQ(track("alone", "--force --mode " + mode).exit_code,
              track("live", "--force --live --mode " + mode).exit_code);
    EXPECT_EQ(read("alone.txt"), read("live.txt")) << mode;
    EXPECT_EQ(read("alone.csv"), read("live.csv")) << mode;
  }
}

TEST_F(LiveProgram, SaysWhereThePageIs) {
  const ProgramResult result = track("said", "--live");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, MatchesRegex("live at http://127.0.0.1:[0-9]+/.token=[0-9a-f]+\n"));
  EXPECT_EQ(track("quiet", "").err, "");
}

TEST_F(LiveProgram, RefusesWhatIsNoPort) {
  for (const char* port : {"65536", "-1", "http"}) {
    const ProgramResult result = track("port", std::string("--live=") + port);
    EXPECT_EQ(result.exit_code, 2) << port;
    EXPECT_THAT(result.err, HasSubstr("expected a port")) << port;
    EXPECT_FALSE(exists("port.txt"));
  }
}

TEST_F(LiveProgram, EndsByABrokenPipeAsWithoutThePage) {
  const std::string pipe = "sequence --quiet --out - ";
  const auto status_of = [&](const std::string& options) {
    const std::string command = "bash -c 'set -o pipefail; cd " + file("").string() + "; " +
                                EDVO_PROGRAM + " track " + pipe + options +
                                " 2> errors | true; echo ${PIPESTATUS[0]} > status'";
    EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
    return read("status");
  };
  EXPECT_EQ(status_of("--live"), status_of(""));
}

TEST_F(LiveProgram, RunsAndTestsAScenarioToTheSameResult) {
  const std::string scenario = write_scenario("small", "0.01").string();
  ASSERT_EQ(run_program("run '" + scenario + "' --quiet --out " + path("alone")).exit_code, 0);
  ASSERT_EQ(run_program("run '" + scenario + "' --quiet --live --out " + path("live")).exit_code,
            0);
  for (const char* name : {"/trajectory.txt", "/frames.csv", "/report.json"}) {
    EXPECT_EQ(read(std::string("alone") + name), read(std::string("live") + name)) << name;
  }
  const std::string options = "' --quiet --cache " + path("cache");
  const ProgramResult alone = run_program("test '" + scenario + options);
  const ProgramResult live = run_program("test '" + scenario + options + " --again --live");
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_THAT(live.err, HasSubstr("live at http://127.0.0.1:"));
}

TEST_F(LiveProgram, ViewsATrackUntilCtrlC) {
  for (const std::string mode : {"rgbd --debug-images 4", "mono --bootstrap rgbd"}) {
    ASSERT_EQ(track("seen", "--force --mode " + mode + " --time-log " + path("seen_times.csv"))
                      .exit_code %
                  5,
              0);
    const ProgramResult viewed =
        run_program("view " + path("seen.txt"), "timeout --preserve-status -s INT 3 ");
    EXPECT_EQ(viewed.exit_code, 130) << viewed.err;
    EXPECT_THAT(viewed.err, MatchesRegex("http://127.0.0.1:[0-9]+/.token=[0-9a-f]+\n"));
  }
  const ProgramResult other =
      run_program("view " + path("seen.txt") + " --frame-log " + path("sequence/rgb.txt"));
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, HasSubstr("rgb.txt: is no log of frames"));
}

TEST_F(LiveProgram, ViewsReportsAndTrajectoriesAlone) {
  write("bad.txt", "no trajectory\n");
  EXPECT_EQ(run_program("view " + path("bad.txt")).exit_code, 3);
  EXPECT_EQ(run_program("view " + path("r.html") + " --frame-log " + path("bad.txt")).exit_code, 2);
  write("other.html", "<html></html>");
  std::filesystem::create_directory(file("empty"));
  for (const char* name : {"other.html", "empty", "none"}) {
    const ProgramResult result = run_program("view " + path(name));
    EXPECT_EQ(result.exit_code, 3) << name;
    EXPECT_THAT(result.err, HasSubstr("expected")) << name;
  }
}

}  // namespace
