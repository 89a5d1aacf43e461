#pragma once

#include <cstddef>
#include <functional>

namespace tools {

/// Calls `work` with 0 to count - 1 on at most `jobs` threads at a time. The first exception keeps
/// further jobs from starting and is rethrown when those that run have ended.
void run_jobs(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace tools
