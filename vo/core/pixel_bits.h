#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <opencv2/core.hpp>

namespace vo {

constexpr int kPixelsPerWord = 64;

inline int words_of(int cols) {
  return (cols + kPixelsPerWord - 1) / kPixelsPerWord;
}

/// Packs the uppermost bits of 64 adjacent pixels into a word, the first pixel in the lowest bit.
inline std::uint64_t packed_word(const uchar* pixels) {
  std::uint64_t word = 0;
#if defined(__SSE2__)
  for (int i = 0; i < kPixelsPerWord; i += 16) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels + i));
    word |= static_cast<std::uint64_t>(_mm_movemask_epi8(bytes)) << i;
  }
#else
  for (int i = 0; i < kPixelsPerWord; ++i) {
    word |= static_cast<std::uint64_t>(pixels[i] >> 7) << i;
  }
#endif
  return word;
}

/// Packs the pixels of a mask's row, 0 or 255 each, from column 64 * `word` on into a word, the
/// first pixel in the lowest bit; bits beyond the row are 0.
inline std::uint64_t mask_word(const uchar* row, int cols, int word) {
  const int first = word * kPixelsPerWord;
  if (cols - first >= kPixelsPerWord) {
    return packed_word(row + first);
  }
  std::array<uchar, kPixelsPerWord> last{};
  std::copy(row + first, row + cols, last.begin());
  return packed_word(last.data());
}

/// Calls `visit(i)` for each bit i that is set, from the lowest to the highest.
template <typename Visit>
void for_each_bit(std::uint64_t word, Visit visit) {
  for (; word != 0; word &= word - 1) {
    visit(std::countr_zero(word));
  }
}

/// Calls `visit(u)` for each column u of a mask's row that is set; pixels are 0 or 255.
template <typename Visit>
void for_each_set(const uchar* row, int cols, Visit visit) {
  for (int word = 0; word < words_of(cols); ++word) {
    for_each_bit(mask_word(row, cols, word), [&](int i) { visit(word * kPixelsPerWord + i); });
  }
}

}  // namespace vo
