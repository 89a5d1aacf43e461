#include "tools/processes/job_pool.h"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace {

TEST(JobPool, DoesEveryJobOnce) {
  for (const int jobs : {1, 3, 50}) {
    std::vector<std::atomic<int>> done(20);
    tools::run_jobs(done.size(), jobs, [&](std::size_t i) { ++done[i]; });
    for (const std::atomic<int>& count : done) {
      EXPECT_EQ(count, 1);
    }
  }
  tools::run_jobs(0, 4, [](std::size_t) { FAIL(); });
}

TEST(JobPool, AnErrorStopsWhatHasNotBegunAndIsThrown) {
  std::atomic<int> done = 0;
  EXPECT_EQ(support::error_text([&] {
              tools::run_jobs(1000, 2, [&](std::size_t) {
                ++done;
                vo::fail("broken");
              });
            }),
            "broken");
  EXPECT_LE(done, 2);
}

}  // namespace
