#include "synth/sequence/frame_share.h"

#include <cstdint>
#include <numeric>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace synth {
namespace {

constexpr std::int64_t kMaxNumber = 1'000'000'000;

using NumberPair = std::pair<std::size_t, std::size_t>;

std::size_t parse_count(const std::string& text) {
  const std::int64_t value = vo::parse_integer(text);
  vo::require(value >= 0 && value <= kMaxNumber, "out of range");
  return static_cast<std::size_t>(value);
}

/// Returns the numbers on both sides of a separator; `otherwise` replaces an empty side. Throws
/// vo::Error.
NumberPair parse_pair(const std::string& text, char separator, const NumberPair& otherwise) {
  const std::size_t middle = text.find(separator);
  vo::require(middle != std::string::npos, "only one number");
  const std::string first = text.substr(0, middle);
  const std::string second = text.substr(middle + 1);
  return {first.empty() ? otherwise.first : parse_count(first),
          second.empty() ? otherwise.second : parse_count(second)};
}

}  // namespace

void parse_frames(const std::string& text, FrameShare& share) {
  try {
    const FrameShare all;
    const auto [first, end] = parse_pair(text, ':', {all.first, all.end});
    vo::require(first < end, "no frames");
    share.first = first;
    share.end = end;
  } catch (const vo::Error&) {
    vo::fail_as(vo::ErrorKind::usage,
                "--frames: expected A:B with A < B, the frames A to B - 1, got '", text, "'");
  }
}

void parse_shard(const std::string& text, FrameShare& share) {
  try {
    const auto [shard, shards] = parse_pair(text, '/', {0, 0});
    vo::require(shard >= 1 && shard <= shards, "no such part");
    share.shard = shard;
    share.shards = shards;
  } catch (const vo::Error&) {
    vo::fail_as(vo::ErrorKind::usage, "--shard: expected K/N with K from 1 to N, got '", text, "'");
  }
}

std::vector<std::size_t> frames_of(const FrameShare& share, std::size_t count) {
  const std::size_t end = share.end == FrameShare{}.end ? count : share.end;
  if (share.first >= end || end > count) {
    vo::fail_as(vo::ErrorKind::usage, "--frames: expected a range within the ", count,
                " frames of the sequence, got ", share.first, ":", end);
  }
  const std::size_t length = end - share.first;
  const auto start_of = [&](std::size_t part) {
    return share.first + part * length / share.shards;
  };
  std::vector<std::size_t> frames(start_of(share.shard) - start_of(share.shard - 1));
  std::iota(frames.begin(), frames.end(), start_of(share.shard - 1));
  return frames;
}

}  // namespace synth
