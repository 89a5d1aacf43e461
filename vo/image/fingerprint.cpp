#include "vo/image/fingerprint.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "vo/core/hash.h"
#include "vo/core/instruction_set.h"

namespace vo {
namespace {

/// The widest register, or as many narrower ones as hold its lanes.
using Lanes = std::uint32_t __attribute__((vector_size(64)));

/// Hashes of 32 bits side by side, which the processor computes at once: each takes every 64th word
/// of a row. Each step is a bijection of the hash, so that two rows that differ in one word differ.
struct alignas(64) LaneHashes {
  static constexpr std::size_t kBytes = 4 * sizeof(Lanes);  // that a step takes

  Lanes a{1}, b{2}, c{3}, d{4};

  EDVO_INLINE static void step(const Lanes& words, Lanes& hash) {
    constexpr std::uint32_t kOdd = 0x9e3779b1U;
    hash = (hash ^ words) * kOdd;
    hash = hash << 13U | hash >> 19U;
  }

  EDVO_INLINE void add(const uchar* bytes) {
    std::array<Lanes, 4> words;
    std::memcpy(words.data(), bytes, kBytes);
    step(words[0], a);
    step(words[1], b);
    step(words[2], c);
    step(words[3], d);
  }

  EDVO_INLINE void add_row(const uchar* row, std::size_t bytes) {
    std::size_t at = 0;
    for (; at + kBytes <= bytes; at += kBytes) {
      add(row + at);
    }
    if (at < bytes) {
      std::array<uchar, kBytes> last{};
      std::memcpy(last.data(), row + at, bytes - at);
      add(last.data());
    }
  }

  std::uint64_t mixed_together() const {
    std::uint64_t hash = 0;
    for (const Lanes* lanes : {&a, &b, &c, &d}) {
      std::array<std::uint64_t, sizeof(Lanes) / sizeof(std::uint64_t)> parts;
      std::memcpy(parts.data(), lanes, sizeof(*lanes));
      for (const std::uint64_t part : parts) {
        hash = mixed(hash ^ part);
      }
    }
    return hash;
  }
};

EDVO_INLINE void add_rows(const cv::Mat& image, LaneHashes& hashes) {
  const std::size_t bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
  LaneHashes sum = hashes;
  for (int v = 0; v < image.rows; ++v) {
    sum.add_row(image.data + static_cast<std::size_t>(v) * image.step[0], bytes);
  }
  hashes = sum;
}

void add_rows_baseline(const cv::Mat& image, LaneHashes& hashes) {
  add_rows(image, hashes);
}

EDVO_TARGET_AVX2 void add_rows_avx2(const cv::Mat& image, LaneHashes& hashes) {
  add_rows(image, hashes);
}

EDVO_TARGET_AVX512 void add_rows_avx512(const cv::Mat& image, LaneHashes& hashes) {
  add_rows(image, hashes);
}

}  // namespace

std::uint64_t fingerprint(const cv::Mat& image) {
  if (image.empty()) {
    return 0;
  }
  const InstructionSet set = available_instruction_set();
  const auto add = version_for(set, add_rows_baseline, add_rows_avx2, add_rows_avx512);
  LaneHashes hashes;
  add(image, hashes);
  return hashes.mixed_together();
}

}  // namespace vo
