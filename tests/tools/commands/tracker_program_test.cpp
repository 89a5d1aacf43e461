#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tests/support/folder_contents.h"
#include "tests/support/program_test.h"
#include "tools/processes/scratch_folder.h"
#include "tools/processes/shell_words.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;
using testing::Not;

/// Three scenarios of one sequence, which lies in the cache, and trackers that misbehave.
class TrackerProgram : public support::ProgramTest {
 protected:
  TrackerProgram() {
    for (const char* name : {"a", "b", "c"}) {
      write_scenario(name, "100");
    }
  }

  static std::string tracker(const std::string& how) {
    const std::string peer = EDVO_SOURCE_DIR "/tests/peers/misbehaving.py";
    return " --tracker " + tools::shell_quoted("python3 " + tools::shell_quoted(peer) + " " + how) +
           " ";
  }

  ProgramResult test(const std::string& rest, const std::string& before = "") const {
    return run_program("test --quiet --cache " + path("cache") + " " + rest, before);
  }

  /// Tests a tracker on all scenarios, one at a time. It must leave the cache as it was.
  ProgramResult misbehave(const std::string& how, const std::string& options = "",
                          const std::string& before = "") const {
    EXPECT_EQ(test(path("scenarios/a.toml")).exit_code, 0);
    const auto sequences = support::contents(file("cache/sequences"));
    const ProgramResult result =
        test(path("scenarios") + tracker(how) + options + " --jobs 1 --json " + path("r.json") +
                 " --junit " + path("r.xml") + " --report " + path("r.html"),
             before);
    EXPECT_EQ(support::contents(file("cache/sequences")), sequences);
    return result;
  }

  /// Returns the kind of the problem of a scenario; "none" without one.
  std::string kind_of(std::size_t scenario) const {
    return json::parse(read("r.json"))["scenarios"][scenario]["trials"][0].value("problem_kind",
                                                                                 "none");
  }

  /// Expects that all scenarios have a problem of this kind that is told in one line.
  void expect_all(const ProgramResult& result, const std::string& kind,
                  const std::string& sentence) const {
    EXPECT_EQ(result.exit_code, 4) << result.out << result.err;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(kind_of(i), kind);
      EXPECT_THAT(result.out, HasSubstr(std::string(1, static_cast<char>('a' + i)) +
                                        ": the tracker" + sentence));
    }
    EXPECT_THAT(result.out, HasSubstr("FAIL  3 scenarios, 3 not measured"));
    EXPECT_THAT(read("r.xml"), HasSubstr("type=\"" + kind + "\""));
    EXPECT_TRUE(exists("r.html"));
  }
};

TEST_F(TrackerProgram, ThatCopiesTheTruthFindsNone) {
  expect_all(misbehave("copies_truth"), "tracker", " ended with exit code 1");
}

TEST_F(TrackerProgram, ThatGuessesTheTruthIsImplausible) {
  fs::create_directory(file("elsewhere"));
  EXPECT_EQ(test(path("scenarios/a.toml")).exit_code, 0);
  fs::copy(file("cache/sequences"), file("elsewhere"), fs::copy_options::recursive);
  expect_all(misbehave("guesses_truth " + path("elsewhere")), "implausible",
             "'s trajectory is too good to be true");
}

TEST_F(TrackerProgram, ThatLooksIntoTheCacheFindsItEmptyOrIsImplausible) {
  misbehave("guesses_truth " + path("cache"));
  EXPECT_EQ(kind_of(0), ::geteuid() == 0 ? "tracker" : "implausible");
}

TEST_F(TrackerProgram, ThatWritesItsInputChangesNothingOfTheCache) {
  const ProgramResult result = misbehave("writes_input");
  expect_all(result, "tracker", " wrote no trajectory");
  if (::geteuid() == 0) {
    EXPECT_THAT(result.out, Not(HasSubstr("changed its input")));
  }
}

TEST_F(TrackerProgram, ThatForksADaemonEndsWithIt) {
  expect_all(misbehave("forks_daemon " + path("daemon")), "tracker", " wrote no trajectory");
  EXPECT_NE(::kill(std::stoi(read("daemon")), 0), 0);
}

TEST_F(TrackerProgram, ThatPrintsForEverIsEnded) {
  expect_all(misbehave("prints_for_ever", "--output-limit 20"), "tracker",
             " was ended for printing more than 20 MB (--output-limit); it last said: l");
}

TEST_F(TrackerProgram, ThatHangsIsEnded) {
  expect_all(misbehave("hangs", "--time-limit 0.5"), "timeout",
             " was ended after 0.5 s, its time limit");
}

TEST_F(TrackerProgram, ThatLeavesHalfAFileIsRefused) {
  expect_all(misbehave("leaves_half_a_file"), "tracker", "'s trajectory ends within a line");
}

TEST_F(TrackerProgram, ThatCrashesOnceCostsOneRow) {
  const ProgramResult result = misbehave("crashes_the_third_time " + path("count"));
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.out, HasSubstr("c: the tracker crashed (signal 11)"));
  EXPECT_THAT(result.out, HasSubstr("FAIL  3 scenarios, 2 within their bounds, 1 not measured"));
  EXPECT_EQ(kind_of(0), "none");
  EXPECT_EQ(kind_of(2), "crash");
}

TEST_F(TrackerProgram, EndsAtOnceWithEdvoWhileItPrints) {
  const auto start = std::chrono::steady_clock::now();
  const ProgramResult result = misbehave("prints_for_ever", "--output-limit 1e9",
                                         "timeout --preserve-status --signal TERM 1 ");
  EXPECT_EQ(result.exit_code, 75);
  EXPECT_THAT(result.err, HasSubstr("terminated"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(TrackerProgram, EndsWithItsDaemonWhenEdvoIsKilled) {
  const std::string hang =
      tools::shell_quoted("sh -c 'python3 " EDVO_SOURCE_DIR
                          "/tests/peers/misbehaving.py forks_daemon \"$0\"; sleep 600' " +
                          path("daemon"));
  const tools::ScratchFolder scratch;  // for what edvo cannot remove
  test(path("scenarios/a.toml") + " --tracker " + hang,
       "TMPDIR='" + scratch.path().string() +
           "' sh -c '\"$@\" & edvo=$!; for i in $(seq 600); do [ -s \"" + file("daemon").string() +
           "\" ] && break; sleep 0.05; done; kill -KILL $edvo; wait' sh ");
  ASSERT_TRUE(exists("daemon"));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (::kill(std::stoi(read("daemon")), 0) == 0 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_NE(::kill(std::stoi(read("daemon")), 0), 0);
}

TEST_F(TrackerProgram, NeedsNoShell) {
  const ProgramResult shell = test(path("scenarios") + " --tracker 'vo {sequence} > {output}'");
  EXPECT_EQ(shell.exit_code, 2);
  EXPECT_THAT(shell.err, HasSubstr("has an unquoted >, which only a shell understands"));
  EXPECT_EQ(test(path("scenarios") + " --tracker vo --memory-limit 0").exit_code, 2);
}

TEST_F(TrackerProgram, ThatCrashesEdvoCostsOneRow) {
  const ProgramResult result = misbehave("kills_edvo");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.out, HasSubstr("a: edvo crashed on it (signal 6)"));
  EXPECT_THAT(read("r.xml"), HasSubstr("type=\"crash\""));
  EXPECT_EQ(kind_of(2), "crash");
}

/// Scenarios that are unlike others.
class TrialProcess : public support::ProgramTest {};

TEST_F(TrialProcess, OfAnOddScenarioCostsOneRow) {
  write_scenario("good", "100");
  const std::string good = read("scenarios/good.toml");
  std::string huge = good;
  huge.replace(huge.find("radius = 1.2"), 12, "radius = 1e19");  // Embree may assert that it is not
  write("scenarios/huge.toml", huge);
  std::string deep;
  for (int i = 0; i < 15000; ++i) {
    deep += "a.";
  }
  write("scenarios/nested.toml", deep + "a = 1\n");
  write("scenarios/odd\xff.toml", good);
  const ProgramResult result =
      run_program("test --quiet --cache " + path("cache") + " " + path("scenarios") + " --json " +
                  path("r.json") + " --junit " + path("r.xml") + " --report " + path("r.html"));
  EXPECT_EQ(result.exit_code, 3) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("nested.toml:1: a key has more than 64 parts"));
  EXPECT_THAT(result.out, HasSubstr("FAIL  4 scenarios, 2 within their bounds"));
  const json scenarios = json::parse(read("r.json"))["scenarios"];
  EXPECT_EQ(scenarios[0]["verdict"], "ok");
  EXPECT_NE(scenarios[1]["verdict"], "ok");
  EXPECT_EQ(scenarios[2]["verdict"], "ERROR");
  EXPECT_EQ(scenarios[3]["name"], "odd?");
  EXPECT_EQ(scenarios[3]["verdict"], "ok");
  EXPECT_THAT(read("r.xml"), HasSubstr("tests=\"4\""));
  EXPECT_THAT(read("r.html"), HasSubstr("2 of 4 scenarios passed"));
}

}  // namespace
