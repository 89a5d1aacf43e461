#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "vo/core/pixel_bits.h"
#include "vo/image/view_grid.h"

namespace vo {

/// Returns the tiles of whose index `holds` says true, called once for each, 64 at a time.
template <typename Holds>
ViewTiles::Set tiles_where(const Holds& holds) {
  constexpr std::size_t kWord = kPixelsPerWord;
  ViewTiles::Set tiles;
  for (std::size_t first = 0; first < ViewTiles::kCount; first += kWord) {
    std::array<uchar, kWord> word{};
    const std::size_t count = std::min(kWord, ViewTiles::kCount - first);
    for (std::size_t i = 0; i < count; ++i) {
      word[i] = holds(first + i) ? 255 : 0;
    }
    tiles |= ViewTiles::Set(packed_word(word.data())) << first;
  }
  return tiles;
}

}  // namespace vo
