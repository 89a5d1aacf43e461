#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vo/core/image.h"
#include "vo/core/instruction_set.h"
#include "vo/core/pixel_bits.h"

namespace vo {

/// Gradients of one row of an image, by 3x3 Sobel kernels with the border replicated, and zeros
/// beyond the row up to whole words of 64 pixels. Squared magnitudes also have a zero on the left.
class GradientRow {
 public:
  void resize(int cols) {
    cols_ = static_cast<std::size_t>(cols);
    smooth_.resize(cols_ + 2);
    difference_.resize(cols_ + 2);
    dx_.assign((cols_ + kPixelsPerWord - 1) / kPixelsPerWord * kPixelsPerWord, 0);
    dy_.assign(dx_.size(), 0);
    squared_.assign(dx_.size() + 2, 0);
  }

  EDVO_INLINE void compute(const ByteImage& image, int v) {
    const uchar* above = image[std::max(v - 1, 0)];
    const uchar* here = image[v];
    const uchar* below = image[std::min(v + 1, image.rows - 1)];
    std::int16_t* __restrict smooth = smooth_.data();
    std::int16_t* __restrict difference = difference_.data();
    for (std::size_t u = 0; u < cols_; ++u) {
      smooth[u + 1] = static_cast<std::int16_t>(above[u] + 2 * here[u] + below[u]);
      difference[u + 1] = static_cast<std::int16_t>(below[u] - above[u]);
    }
    smooth[0] = smooth[1];
    smooth[cols_ + 1] = smooth[cols_];
    difference[0] = difference[1];
    difference[cols_ + 1] = difference[cols_];
    std::int16_t* __restrict dx = dx_.data();
    std::int16_t* __restrict dy = dy_.data();
    int* __restrict squared = squared_.data();
    for (std::size_t u = 0; u < cols_; ++u) {
      const auto gx = static_cast<std::int16_t>(smooth[u + 2] - smooth[u]);
      const auto gy =
          static_cast<std::int16_t>(difference[u] + 2 * difference[u + 1] + difference[u + 2]);
      dx[u] = gx;
      dy[u] = gy;
      squared[u + 1] = gx * gx + gy * gy;
    }
  }

  void clear() { std::fill(squared_.begin(), squared_.end(), 0); }

  const std::int16_t* dx() const { return dx_.data(); }
  const std::int16_t* dy() const { return dy_.data(); }
  const int* squared() const { return squared_.data() + 1; }  ///< valid from -1 to a word's end

 private:
  std::size_t cols_ = 0;
  std::vector<std::int16_t> smooth_;      ///< vertical [1 2 1] sums, a pixel more on either side
  std::vector<std::int16_t> difference_;  ///< vertical differences, a pixel more on either side
  std::vector<std::int16_t> dx_, dy_;
  std::vector<int> squared_;
};

}  // namespace vo
