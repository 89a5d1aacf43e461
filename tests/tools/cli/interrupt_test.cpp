#include "tools/cli/interrupt.h"

#include <csignal>
#include <thread>

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

TEST(RememberSignals, EndsTheProcessAtOnceByAFurtherSignal) {
  const auto raise_twice = [](int first, int second) {
    tools::remember_signals();
    std::raise(first);
    std::this_thread::sleep_for(std::chrono::nanoseconds(tools::kSameRequestNs));
    std::raise(second);
    end_with_verdict();
  };
  EXPECT_EXIT(raise_twice(SIGINT, SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

TEST(RememberSignals, TakesSignalsThatComeTogetherForOneRequest) {
  const auto raise_both = [] {
    tools::remember_signals();
    sigset_t both;
    sigemptyset(&both);
    sigaddset(&both, SIGINT);
    sigaddset(&both, SIGTERM);
    ::sigprocmask(SIG_BLOCK, &both, nullptr);
    std::raise(SIGINT);
    std::raise(SIGTERM);
    ::sigprocmask(SIG_UNBLOCK, &both, nullptr);  // both are delivered here
    end_with_verdict();
  };
  EXPECT_EXIT(raise_both(), testing::ExitedWithCode(1), "");
}

}  // namespace
