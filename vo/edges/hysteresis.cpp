#include "vo/edges/hysteresis.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "vo/core/instruction_set.h"

namespace vo {
namespace {

using Word = std::uint64_t;

/// Returns a table of eight mask pixels, 0 or 255, for each value of eight bits.
constexpr std::array<Word, 256> mask_pixels() {
  std::array<Word, 256> pixels{};
  for (Word bits = 0; bits < pixels.size(); ++bits) {
    for (Word i = 0; i < 8; ++i) {
      pixels[bits] |= ((bits >> i) & 1U) * 0xffU << (8 * i);
    }
  }
  return pixels;
}

void write_row_baseline(const Word* strong, std::size_t cols, uchar* mask) {
  static constexpr std::array<Word, 256> kPixels = mask_pixels();
  constexpr std::size_t kBytes = 8;
  std::array<Word, sizeof(Word)> pixels;
  for (std::size_t u = 0; u < cols; u += sizeof(pixels)) {
    const Word word = *strong++;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      pixels[i] = kPixels[(word >> (kBytes * i)) & 0xffU];
    }
    std::memcpy(mask + u, pixels.data(), std::min(sizeof(pixels), cols - u));
  }
}

#if defined(__x86_64__)
EDVO_TARGET_AVX512 void write_row_avx512(const Word* strong, std::size_t cols, uchar* mask) {
  constexpr std::size_t kPixels = 64;
  for (std::size_t u = 0; u < cols; u += kPixels) {
    const std::size_t count = std::min(kPixels, cols - u);
    const __mmask64 inside = ~Word{0} >> (kPixels - count);
    _mm512_mask_storeu_epi8(mask + u, inside, _mm512_movm_epi8(*strong++));
  }
}
#else
void write_row_avx512(const Word* strong, std::size_t cols, uchar* mask) {
  write_row_baseline(strong, cols, mask);
}
#endif

/// Makes the edges of a row strong that touch strong ones of the row beside it, `source`; returns
/// whether any did. A word lies before and after each row.
EDVO_INLINE bool spread_row(const Word* source, std::size_t words, const Word* __restrict edges,
                            Word* __restrict strong) {
  constexpr unsigned kLast = 63;
  Word changed = 0;
  for (std::size_t w = 0; w < words; ++w) {
    const Word touched = source[w] | source[w] << 1U | source[w] >> 1U |
                         source[static_cast<std::ptrdiff_t>(w) - 1] >> kLast |
                         source[w + 1] << kLast;
    const Word added = edges[w] & touched & ~strong[w];
    strong[w] |= added;
    changed |= added;
  }
  return changed != 0;
}

EDVO_TARGET_AVX2 bool spread_row_avx2(const Word* source, std::size_t words, const Word* edges,
                                      Word* strong) {
  return spread_row(source, words, edges, strong);
}

bool spread_row_baseline(const Word* source, std::size_t words, const Word* edges, Word* strong) {
  return spread_row(source, words, edges, strong);
}

}  // namespace

void Hysteresis::reset(cv::Size size) {
  size_ = size;
  words_ = (static_cast<std::size_t>(size.width) + kBits - 1) / kBits;
  strong_.assign(offset(size.height), 0);
  edges_.assign(strong_.size(), 0);
}

void Hysteresis::follow() {
  for (int v = 0; v < size_.height; ++v) {
    grow(v);
  }
  unseen_below_.assign(static_cast<std::size_t>(size_.height), 1);
  unseen_above_ = unseen_below_;
  const auto spread_unseen = [&](int from, int to, std::vector<char>& unseen) {
    const bool changed =
        std::exchange(unseen[static_cast<std::size_t>(from)], 0) != 0 && spread(from, to);
    if (changed) {
      unseen_below_[static_cast<std::size_t>(to)] = 1;
      unseen_above_[static_cast<std::size_t>(to)] = 1;
    }
    return changed;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int v = 1; v < size_.height; ++v) {
      changed |= spread_unseen(v - 1, v, unseen_below_);
    }
    for (int v = size_.height - 1; v > 0; --v) {
      changed |= spread_unseen(v, v - 1, unseen_above_);
    }
  }
}

/// Spreads strong edges from one row to the one beside it; returns whether any became strong.
bool Hysteresis::spread(int from, int to) {
  const auto spread_row = available_instruction_set() == InstructionSet::baseline
                              ? spread_row_baseline
                              : spread_row_avx2;
  const bool changed = spread_row(strong_.data() + offset(from), words_, edges_.data() + offset(to),
                                  strong_.data() + offset(to));
  if (changed) {
    grow(to);
  }
  return changed;
}

void Hysteresis::grow(int v) {
  grow_right(strong_.data() + offset(v), edges_.data() + offset(v));
  grow_left(strong_.data() + offset(v), edges_.data() + offset(v));
}

/// Grows strong edges to the right: adding a seed to a run of ones carries from the seed to the
/// run's end, where it leaves zeros.
void Hysteresis::grow_right(Word* strong, const Word* edges) const {
  Word carry = 0;
  for (std::size_t w = 0; w < words_; ++w) {
    const Word seeded = edges[w] + strong[w];
    const Word sum = seeded + carry;
    carry = seeded < edges[w] || sum < seeded ? 1 : 0;
    strong[w] |= edges[w] & ~sum;
  }
}

/// Grows strong edges to the left by parallel prefix: seeds move by 1, 2, 4, ... pixels where all
/// pixels on the way are edges.
void Hysteresis::grow_left(Word* strong, const Word* edges) const {
  Word from_right = 0;
  for (std::size_t w = words_; w-- > 0;) {
    Word seeds = strong[w] | (edges[w] & from_right << (kBits - 1));
    Word way = edges[w];
    for (unsigned step = 1; step < kBits; step *= 2) {
      const Word added = way & seeds >> step & ~seeds;
      if (added == 0) {
        break;
      }
      seeds |= added;
      way &= way >> step;
    }
    strong[w] = seeds;
    from_right = seeds & 1U;
  }
}

void Hysteresis::write_strong(EdgeMask& mask) const {
  const auto write_row =
      available_instruction_set() == InstructionSet::avx512 ? write_row_avx512 : write_row_baseline;
  for (int v = 0; v < size_.height; ++v) {
    write_row(strong_.data() + offset(v), static_cast<std::size_t>(size_.width), mask[v]);
  }
}

}  // namespace vo
