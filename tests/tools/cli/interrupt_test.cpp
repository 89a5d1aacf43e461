#include "tools/cli/interrupt.h"

#include <csignal>

#include <gtest/gtest.h>
#include <unistd.h>

namespace {

/// Ends a process of a test: with 1 where a signal has been recorded.
[[noreturn]] void end_with_verdict() {
  ::_exit(tools::is_interrupted() ? 1 : 0);
}

TEST(RememberSignals, LeavesThoseAloneThatTheParentIgnored) {
  for (const int signal : {SIGHUP, SIGINT}) {
    const auto raised = [&](auto inherited) {
      std::signal(signal, inherited);
      tools::remember_signals();
      std::raise(signal);
      end_with_verdict();
    };
    EXPECT_EXIT(raised(SIG_IGN), testing::ExitedWithCode(0), "") << signal;
    EXPECT_EXIT(raised(SIG_DFL), testing::ExitedWithCode(1), "") << signal;
  }
}

}  // namespace
