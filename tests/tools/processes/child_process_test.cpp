#include "tools/processes/child_process.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "tools/processes/process_tree.h"
#include "vo/files/input.h"

namespace {

using std::chrono::steady_clock;
using testing::HasSubstr;
using tools::ChildEnd;
using tools::ExceededLimit;

/// Python that becomes a daemon, in a session and group of its own and with no parent, and writes
/// its process to a file.
constexpr const char* kDaemon = R"(
import os, sys, time
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        with open("daemon.part", "w") as file:
            file.write(str(os.getpid()))
        os.rename("daemon.part", "daemon")
        time.sleep(60)
    os._exit(0)
while not os.path.exists("daemon"):
    time.sleep(0.01)
if sys.argv[1] == "wait":
    time.sleep(60)
while sys.argv[1] == "print":
    print("daemon")
)";

class ChildProcess : public testing::Test {
 protected:
  ChildEnd run(
      const std::vector<std::string>& words, const tools::ChildLimits& limits = {},
      const vo::WaitObserver& waiting = [] {}) const {
    return tools::run_child({.words = words, .folder = folder_.path()}, limits, waiting);
  }

  /// Runs the daemon's parent; returns the daemon.
  pid_t run_daemon(
      const char* what, const tools::ChildLimits& limits,
      const vo::WaitObserver& waiting = [] {}) const {
    run({"python3", "-c", kDaemon, what}, limits, waiting);
    return daemon();
  }

  pid_t daemon() const { return std::stoi(vo::read_file(folder_.path() / "daemon")); }

  bool has_started() const { return std::filesystem::exists(folder_.path() / "daemon"); }

  static bool is_running(pid_t process) { return ::kill(process, 0) == 0; }

  support::TempFolder folder_;
};

TEST_F(ChildProcess, EndsAsTheProgramDoes) {
  EXPECT_EQ(run({"sh", "-c", "exit 7"}).exit_code, 7);
  EXPECT_EQ(run({"sh", "-c", "kill -TERM $$"}).signal, SIGTERM);
  EXPECT_EQ(run({"echo", "a  b", "c"}).tail, "a  b c\n");
  EXPECT_THAT(support::error_text([&] { run({"/no/such/program"}); }),
              HasSubstr("/no/such/program: cannot be started: No such file"));
}

TEST_F(ChildProcess, KeepsTheTailOfMuchOutput) {
  const ChildEnd end = run({"sh", "-c", "head -c 20m /dev/zero; echo last"});
  EXPECT_EQ(end.tail.size(), 4096U);
  EXPECT_THAT(end.tail, testing::EndsWith("last\n"));
}

TEST_F(ChildProcess, EndsWithItsDaemons) {
  EXPECT_FALSE(is_running(run_daemon("end", {})));
}

TEST_F(ChildProcess, IsEndedWithItsDaemonsAtALimit) {
  EXPECT_FALSE(is_running(run_daemon("print", {.output = 1000})));
  EXPECT_EQ(run({"sleep", "60"}, {.time = 0.1}).exceeded, ExceededLimit::time);
}

TEST_F(ChildProcess, IsEndedWithItsDaemonsWhenItIsNoLongerWaitedFor) {
  const auto stop = [&] { has_started() ? throw vo::Error("stopped") : void(); };
  EXPECT_EQ(support::error_text([&] { run_daemon("wait", {}, stop); }), "stopped");
  EXPECT_FALSE(is_running(daemon()));
}

TEST_F(ChildProcess, IsEndedAtOnceWhileItPrints) {
  const steady_clock::time_point start = steady_clock::now();
  const auto stop = [&] {
    steady_clock::now() - start > std::chrono::milliseconds(300) ? throw vo::Error("stopped")
                                                                 : void();
  };
  EXPECT_EQ(support::error_text([&] { run({"yes"}, {}, stop); }), "stopped");
  EXPECT_LT(steady_clock::now() - start, std::chrono::seconds(5));
}

TEST_F(ChildProcess, IsEndedWithItsDaemonsWhenThisProcessIsKilled) {
  const pid_t parent = ::fork();
  if (parent == 0) {
    run_daemon("wait", {});
    ::_exit(0);
  }
  while (!has_started()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  const steady_clock::time_point end = steady_clock::now() + std::chrono::seconds(10);
  while (is_running(daemon()) && steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(is_running(daemon()));
}

}  // namespace
