#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace synth {

/// The frames of a sequence that one process renders: of a range, one of several parts that follow
/// each other and differ in length by one frame at most.
struct FrameShare {
  std::size_t first = 0;
  std::size_t end = std::numeric_limits<std::size_t>::max();  ///< one after the last
  std::size_t shard = 1;                                      ///< 1 to `shards`
  std::size_t shards = 1;
};

/// `A:B`, frames A to B - 1; either may be left out. Throws vo::Error of kind usage.
void parse_frames(const std::string& text, FrameShare& share);

/// `K/N`, the K-th of N parts, K from 1. Throws vo::Error of kind usage.
void parse_shard(const std::string& text, FrameShare& share);

/// Of a sequence of `count` frames. Throws vo::Error of kind usage when the range ends beyond them.
std::vector<std::size_t> frames_of(const FrameShare& share, std::size_t count);

}  // namespace synth
