#pragma once

#include <algorithm>
#include <cstddef>

#include <opencv2/core/utility.hpp>

namespace vo {

/// Calls `body(i)` for each i below `count`, spread over at most this many threads; one thread
/// calls it in order. Calls must not depend on each other.
template <typename Body>
void parallel_for(std::size_t count, int threads, const Body& body) {
  const auto part = [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i) {
      body(static_cast<std::size_t>(i));
    }
  };
  const cv::Range all(0, static_cast<int>(count));
  if (threads <= 1) {
    part(all);
  } else {
    cv::parallel_for_(all, part, threads);
  }
}

}  // namespace vo
