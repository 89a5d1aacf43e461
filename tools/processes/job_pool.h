#pragma once

#include <cstddef>
#include <functional>

namespace tools {

/// Calls `work` with 0 to count - 1, at most `jobs` at a time, in threads that share nothing. The
/// first exception stops what has not begun and is thrown when what has begun is over.
void run_jobs(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace tools
