#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vo/core/image.h"

namespace vo {

/// Edge bits of 64 pixels of a row before weak edges are followed, the leftmost in the lowest bit.
struct EdgeWord {
  std::uint64_t edges = 0;   ///< weak and strong edges
  std::uint64_t strong = 0;  ///< the strong ones among `edges`
};

/// Canny's hysteresis: weak edges that touch a strong one, in any of eight directions or through
/// other weak ones, are strong. 64 pixels of a row are one word, whose runs grow all at once.
class Hysteresis {
 public:
  /// Sets the image size and removes all edges.
  void reset(cv::Size size);

  /// Sets the pixels of row v from column 64 * `word` on; bits beyond the image must be 0.
  void set(int v, int word, const EdgeWord& pixels) {
    const std::size_t index = offset(v) + static_cast<std::size_t>(word);
    edges_[index] = pixels.edges;
    strong_[index] = pixels.strong;
  }

  void follow();

  void write_strong(EdgeMask& mask) const;  ///< `mask` must have the image's size

 private:
  using Word = std::uint64_t;
  static constexpr std::size_t kBits = 64;

  void grow(int v);
  bool spread(int from, int to);
  void grow_right(Word* strong, const Word* edges) const;
  void grow_left(Word* strong, const Word* edges) const;
  std::size_t offset(int v) const { return static_cast<std::size_t>(v) * (words_ + 1) + 1; }

  cv::Size size_;
  std::size_t words_ = 0;     ///< words of a row
  std::vector<Word> strong_;  ///< row by row, an empty word before, between and after them
  std::vector<Word> edges_;   ///< weak and strong pixels, laid out as `strong_`
  std::vector<char> unseen_below_, unseen_above_;  ///< rows changed since spread down, up
};

}  // namespace vo
