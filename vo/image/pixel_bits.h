#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <opencv2/core.hpp>

namespace vo {

constexpr int kPixelsPerWord = 64;
constexpr int kPixelsPerStep = 8;  ///< that are packed at a time

/// The lowest bit of each of eight pixels side by side, the first one's lowest: the product shifts
/// each to its place in the uppermost byte.
inline std::uint64_t packed_bits(std::uint64_t pixels) {
  constexpr std::uint64_t kLowest = 0x0101010101010101U;
  constexpr std::uint64_t kGather = 0x0102040810204080U;
  return ((pixels & kLowest) * kGather) >> 56U;
}

/// One bit of each of 64 pixels.
inline std::uint64_t packed_word(const uchar* pixels, unsigned bit) {
  std::uint64_t word = 0;
  for (int i = 0; i < kPixelsPerWord; i += kPixelsPerStep) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, pixels + i, kPixelsPerStep);
    word |= packed_bits(bytes >> bit) << i;
  }
  return word;
}

/// Calls `visit(u)` for each pixel of a mask's row that is set, 0 or 255 each.
template <typename Visit>
void for_each_set(const uchar* row, int cols, Visit visit) {
  for (int first = 0; first < cols; first += kPixelsPerWord) {
    const int count = std::min(kPixelsPerWord, cols - first);
    std::array<uchar, kPixelsPerWord> last{};
    if (count < kPixelsPerWord) {
      std::copy(row + first, row + cols, last.begin());
    }
    std::uint64_t word = packed_word(count < kPixelsPerWord ? last.data() : row + first, 0);
    for (; word != 0; word &= word - 1) {
      visit(first + std::countr_zero(word));
    }
  }
}

}  // namespace vo
