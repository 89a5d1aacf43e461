#include "tools/processes/job_pool.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <vector>

namespace tools {

void run_jobs(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto take_jobs = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        work(i);
      }
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::vector<std::future<void>> workers;
  const std::size_t threads = std::min(count, static_cast<std::size_t>(std::max(jobs, 1)));
  for (std::size_t i = 0; i < threads; ++i) {
    workers.push_back(std::async(std::launch::async, take_jobs));
  }
  for (const std::future<void>& worker : workers) {
    worker.wait();
  }
  for (std::future<void>& worker : workers) {
    worker.get();
  }
}

}  // namespace tools
