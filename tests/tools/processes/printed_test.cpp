#include "tools/processes/printed.h"

#include <csignal>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "tools/processes/foreground.h"
#include "vo/core/error.h"
#include "vo/files/input.h"

namespace {

using tools::Printed;
using tools::run_and_read;
using tools::run_in_foreground;

TEST(Printed, IsAllOfStdoutAndTheEndOfStderr) {
  const Printed printed =
      run_and_read({.words = {"sh", "-c", "seq 5000; seq 5000 >&2; exit 7"}}, [] {});
  EXPECT_EQ(printed.exit_code, 7);
  EXPECT_EQ(printed.out.size(), 9U * 2 + 90 * 3 + 900 * 4 + 4001 * 5);
  EXPECT_EQ(printed.err.size(), 4096U);
  EXPECT_TRUE(printed.err.ends_with("4999\n5000\n"));
}

TEST(Printed, HasTheExitCodesOfAShell) {
  EXPECT_EQ(run_and_read({.words = {"sh", "-c", "kill -TERM $$"}}, [] {}).exit_code, 128 + SIGTERM);
  EXPECT_EQ(run_and_read({.words = {"edvo-no-such-program"}}, [] {}).exit_code, 127);
  EXPECT_TRUE(tools::is_in_path("sh"));
  EXPECT_FALSE(tools::is_in_path("edvo-no-such-program"));
}

TEST(Foreground, RunsInTheFolderAndHasTheExitCodesOfAShell) {
  const support::TempFolder folder;
  EXPECT_EQ(run_in_foreground({.words = {"sh", "-c", "pwd > out; exit 5"}, .folder = folder.path()},
                              [] {}),
            5);
  EXPECT_EQ(vo::read_file(folder.path() / "out"), folder.path().string() + "\n");
  EXPECT_EQ(run_in_foreground({.words = {"sh", "-c", "kill -TERM $$"}}, [] {}), 128 + SIGTERM);
  EXPECT_NE(support::error_text([] {
              run_in_foreground({.words = {"edvo-no-such-program"}}, [] {});
            }).find("edvo-no-such-program: cannot be started"),
            std::string::npos);
}

TEST(Foreground, EndsItsProgramWhenNobodyWaits) {
  const support::TempFolder folder;
  const std::string script =
      "trap 'kill $!; echo told > told; exit 75' TERM; sleep 60 & echo > ready; wait";
  EXPECT_EQ(support::error_text([&] {
              run_in_foreground({.words = {"sh", "-c", script}, .folder = folder.path()}, [&] {
                vo::require(!std::filesystem::exists(folder.path() / "ready"), "stopped");
              });
            }),
            "stopped");
  EXPECT_EQ(vo::read_file(folder.path() / "told"), "told\n");
}

}  // namespace
