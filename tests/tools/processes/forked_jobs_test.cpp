#include "tools/processes/forked_jobs.h"

#include <chrono>
#include <csignal>
#include <cstddef>
#include <map>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/error_text.h"
#include "vo/core/error.h"

namespace {

using tools::JobEnd;

/// Runs the jobs; returns how each ended.
std::map<std::size_t, JobEnd> ends_of(std::size_t count, int jobs,
                                      const std::function<std::string(std::size_t)>& work) {
  std::map<std::size_t, JobEnd> ends;
  tools::run_forked(count, jobs,
                    {.work = work, .done = [&](std::size_t i, JobEnd end) { ends[i] = end; }},
                    [] {});
  return ends;
}

TEST(ForkedJobs, ReturnWhatTheyMade) {
  for (const int jobs : {1, 3, 20}) {
    const auto ends = ends_of(7, jobs, [](std::size_t i) { return std::string(100000 * i, 'x'); });
    ASSERT_EQ(ends.size(), 7U);
    for (const auto& [i, end] : ends) {
      EXPECT_TRUE(end.is_complete());
      EXPECT_EQ(end.result, std::string(100000 * i, 'x'));
    }
  }
  EXPECT_TRUE(ends_of(0, 3, [](std::size_t) { return std::string(); }).empty());
}

TEST(ForkedJobs, ThatCrashCostTheirOwnResultAlone) {
  const auto ends = ends_of(4, 2, [](std::size_t i) -> std::string {
    if (i == 1) {
      ::raise(SIGABRT);
    }
    if (i == 2) {
      throw vo::Error("no");
    }
    return "done";
  });
  EXPECT_EQ(ends.at(0).result, "done");
  EXPECT_EQ(ends.at(1).signal, SIGABRT);
  EXPECT_EQ(ends.at(2).exit_code, 1);
  EXPECT_FALSE(ends.at(2).is_complete());
  EXPECT_EQ(ends.at(3).result, "done");
}

TEST(ForkedJobs, LeaveThisProcessAsItWas) {
  int changed = 0;
  ends_of(2, 2, [&](std::size_t) { return std::to_string(++changed); });
  EXPECT_EQ(changed, 0);
}

TEST(ForkedJobs, EndWhenNobodyWaits) {
  const auto start = std::chrono::steady_clock::now();
  const auto stop = [&] {
    if (std::chrono::steady_clock::now() - start > std::chrono::milliseconds(200)) {
      throw vo::Error("stopped");
    }
  };
  const tools::ForkedJobs sleepers{.work =
                                       [](std::size_t) {
                                         std::this_thread::sleep_for(std::chrono::seconds(60));
                                         return std::string();
                                       },
                                   .done = [](std::size_t, const JobEnd&) {}};
  EXPECT_EQ(support::error_text([&] { tools::run_forked(3, 3, sleepers, stop); }), "stopped");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(4));
}

}  // namespace
