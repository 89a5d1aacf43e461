#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace synth {

/// The frames of a sequence that one process renders: one of `shards` consecutive parts of the
/// range [first, end), whose lengths differ by one frame at most.
struct FrameShare {
  std::size_t first = 0;
  std::size_t end = std::numeric_limits<std::size_t>::max();  ///< one past the last; max = no limit
  std::size_t shard = 1;                                      ///< number of the part, 1 to `shards`
  std::size_t shards = 1;
};

/// Parses `A:B`, the frames A to B - 1; either may be left out. Throws vo::Error of kind usage.
void parse_frames(const std::string& text, FrameShare& share);

/// Parses `K/N`, the K-th of N parts, K from 1. Throws vo::Error of kind usage.
void parse_shard(const std::string& text, FrameShare& share);

/// Returns the indices of a share's frames in a sequence of `count` frames. Throws vo::Error of
/// kind usage when the range is empty or ends beyond the sequence.
std::vector<std::size_t> frames_of(const FrameShare& share, std::size_t count);

}  // namespace synth
