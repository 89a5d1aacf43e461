#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/program_test.h"
#include "tests/support/terminal.h"

namespace {

using support::ProgramResult;
using support::run_on_terminal;
using support::run_program;
using support::TerminalResult;
using support::without_colours;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kEscape = "\033[";
constexpr const char* kBad = "\033[1;31m";
constexpr const char* kEnd = "\033[0m";

/// A scenario whose bound does not hold, run into a folder of the test.
class Colour : public support::ProgramTest {
 protected:
  Colour() { write_scenario("broken", "1e-9"); }

  std::string run_words() const {
    return "run " + path("scenarios/broken.toml") + " --quiet --force --debug-images 0 --out " +
           path("out");
  }
};

TEST_F(Colour, IsOnATerminalAndNotInAPipe) {
  const ProgramResult plain = run_program(run_words());
  ASSERT_EQ(plain.exit_code, 4) << plain.err;
  EXPECT_THAT(plain.out, Not(HasSubstr(kEscape)));
  const TerminalResult shown = run_on_terminal(run_words());
  EXPECT_EQ(shown.exit_code, 4);
  EXPECT_THAT(shown.screen, HasSubstr(std::string(kBad) + "VIOLATED" + kEnd));
  EXPECT_THAT(shown.screen, HasSubstr(std::string(kBad) + "FAIL" + kEnd));
  EXPECT_THAT(shown.screen, HasSubstr("\033[32mok\033[0m"));
  EXPECT_EQ(without_colours(shown.screen), plain.out);
}

TEST_F(Colour, IsOfEachStreamByItself) {
  const std::string bad = "evaluate --quiet " + path("none.txt") + " " + path("none.txt");
  const std::string plain = run_program(bad).err;
  EXPECT_THAT(plain, HasSubstr("edvo: "));
  EXPECT_THAT(plain, Not(HasSubstr(kEscape)));
  const TerminalResult shown = run_on_terminal(bad + " >" + path("stdout"));
  EXPECT_THAT(shown.screen, HasSubstr(std::string(kBad) + "edvo:" + kEnd));
  EXPECT_EQ(without_colours(shown.screen), plain);
  run_on_terminal(bad + " 2>" + path("stderr"));
  EXPECT_EQ(read("stderr"), plain);
}

TEST_F(Colour, IsAsTheEnvironmentAndTheOptionSay) {
  const std::string bad = "evaluate --quiet " + path("none.txt") + " " + path("none.txt");
  for (const char* none : {"NO_COLOR=1 ", "NO_COLOR=1 CLICOLOR_FORCE=1 ", "TERM=dumb "}) {
    EXPECT_THAT(run_on_terminal(bad, none).screen, Not(HasSubstr(kEscape))) << none;
  }
  EXPECT_THAT(run_on_terminal(bad, "NO_COLOR= ").screen, HasSubstr(kEscape)) << "empty is not set";
  EXPECT_THAT(run_program(bad, "CLICOLOR_FORCE=1 ").err, HasSubstr(kEscape));
  EXPECT_THAT(run_program(bad + " --color always", "NO_COLOR=1 ").err, HasSubstr(kEscape));
  EXPECT_THAT(run_program("--color=always " + bad).err, HasSubstr(kEscape));
  EXPECT_THAT(run_on_terminal("--color never " + bad).screen, Not(HasSubstr(kEscape)));
  EXPECT_THAT(run_on_terminal(bad + " --color=never").screen, Not(HasSubstr(kEscape)));
}

TEST_F(Colour, IsNeverInFiles) {
  ASSERT_EQ(run_program(run_words() + " --color always").exit_code, 4);
  for (const char* name : {"out/report.md", "out/report.json", "out/frames.csv"}) {
    EXPECT_THAT(read(name), Not(HasSubstr(kEscape))) << name;
  }
  const std::string printed = run_program(run_words() + " --json --color always").out;
  EXPECT_THAT(printed, Not(HasSubstr(kEscape)));
}

TEST_F(Colour, TakesTheValuesThatItsHelpNames) {
  const ProgramResult bad = run_program("inspect x.gltf --color sometimes");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, HasSubstr("--color"));
  for (const char* words : {"--help", "track --help", "path check --help", "completion bash",
                            "manual", "manual track"}) {
    std::string text = run_program(words).out;
    std::erase(text, '\\');
    EXPECT_THAT(text, HasSubstr("--color")) << words;
  }
}

class Progress : public support::ProgramTest {
 protected:
  Progress() { write_scenario("good", "1"); }

  std::string run_words() const {
    return "run " + path("scenarios/good.toml") + " --force --debug-images 0 --out " + path("out");
  }
};

TEST_F(Progress, BeginsBeforeTheFirstFrameIsDone) {
  const TerminalResult result = run_on_terminal(run_words());
  ASSERT_EQ(result.exit_code, 0) << result.screen;
  const std::string& screen = result.screen;
  EXPECT_TRUE(screen.starts_with("\rreading the scene of ")) << screen;
  const std::size_t rendering = screen.find("rendering 1 of 7");
  const std::size_t tracking = screen.find("tracking 1 of 7");
  ASSERT_NE(rendering, std::string::npos) << screen;
  ASSERT_NE(tracking, std::string::npos) << screen;
  EXPECT_LT(rendering, tracking);
  EXPECT_LT(tracking, screen.find("PASS"));
}

TEST_F(Progress, LeavesTheTerminalAsAPipeHasIt) {
  ASSERT_EQ(run_program(run_words()).exit_code, 0);
  const std::string truth = path("out/sequence/groundtruth.txt");
  const std::string evaluate = "evaluate " + truth + " " + path("out/trajectory.txt");
  const ProgramResult plain = run_program(evaluate);
  EXPECT_EQ(plain.err, "");
  EXPECT_EQ(run_on_terminal(evaluate).screen, "\revaluating ...\033[K\r\033[K" + plain.out);
  EXPECT_EQ(run_on_terminal(evaluate + " --quiet").screen, plain.out);
  EXPECT_EQ(run_on_terminal(evaluate, "TERM=dumb ").screen, plain.out);
  const std::string bad = "track " + path("none") + " --out " + path("x.txt");
  const std::string screen = without_colours(run_on_terminal(bad).screen);
  EXPECT_THAT(screen, testing::EndsWith("\033[K\r\033[K" + run_program(bad).err));
}

TEST_F(Progress, FitsIntoALine) {
  const std::string name(200, 'x');
  const std::string screen = run_on_terminal("inspect " + path(name)).screen;
  const std::size_t end = screen.find("\033[K");
  ASSERT_NE(end, std::string::npos) << screen;
  EXPECT_EQ(end, 1U + 79U) << "after the carriage return, of a terminal that knows no size";
}

}  // namespace
