#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vo/core/image.h"

namespace vo {

/// What a pixel is before weak edges are followed.
enum PixelClass : uchar { no_edge = 0, weak_edge = 1, strong_edge = 3 };

/// Canny's hysteresis: weak edges that touch a strong one, in any of eight directions or through
/// other weak ones, are strong. 64 pixels of a row are one word, whose runs grow all at once.
class Hysteresis {
 public:
  explicit Hysteresis(cv::Size size);

  /// The classes of 64 pixels of row v from column 64 `word` on; `no_edge` beyond the image. All
  /// are at first.
  void set(int v, int word, const uchar* classes);

  void follow();

  EdgeMask strong() const;

 private:
  using Word = std::uint64_t;
  static constexpr std::size_t kBits = 64;

  bool spread(int from, int to);
  void grow_right(Word* strong, const Word* edges) const;
  void grow_left(Word* strong, const Word* edges) const;
  Word* row(std::vector<Word>& image, int v) const { return image.data() + offset(v); }
  std::size_t offset(int v) const { return static_cast<std::size_t>(v) * words_; }

  cv::Size size_;
  std::size_t words_;         ///< of a row
  std::vector<Word> strong_;  ///< row by row, the leftmost pixel of a word in its lowest bit
  std::vector<Word> edges_;   ///< weak and strong
};

}  // namespace vo
