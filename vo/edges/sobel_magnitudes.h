#pragma once

#include <cstddef>
#include <vector>

#include "vo/core/image.h"
#include "vo/core/instruction_set.h"
#include "vo/edges/gradient_row.h"

namespace vo {

/// The gradient's Euclidean magnitudes, of 3x3 Sobel kernels on intensities 0..255; the border is
/// replicated.
class SobelMagnitudes {
 public:
  static constexpr int kGreatest = 1442;  ///< floor(1020 sqrt(2))

  /// Of every `row_step`-th row. Memory of an image before is used again.
  void measure(const ByteImage& image, int row_step, InstructionSet set);

  int count() const { return static_cast<int>(count_); }
  int count_below(int magnitude) const;

 private:
  InstructionSet set_ = InstructionSet::baseline;
  GradientRow row_;
  std::size_t count_ = 0;
  std::vector<int> squares_;  ///< the first `count_` of them
};

}  // namespace vo
