#pragma once

#include <cstddef>
#include <vector>

#include "vo/core/image.h"
#include "vo/core/instruction_set.h"
#include "vo/edges/gradient_row.h"

namespace vo {

/// Euclidean magnitudes of the gradient, of 3x3 Sobel kernels on intensities 0..255; the border is
/// replicated.
class SobelMagnitudes {
 public:
  static constexpr int kGreatest = 1442;  ///< greatest possible magnitude, floor(1020 sqrt(2))

  /// Measures every `row_step`-th row. Working memory is reused from image to image.
  void measure(const ByteImage& image, int row_step, InstructionSet set);

  int count() const { return static_cast<int>(count_); }
  int count_below(int magnitude) const;

 private:
  InstructionSet set_ = InstructionSet::baseline;
  GradientRow row_;
  std::size_t count_ = 0;
  std::vector<int> squares_;  ///< squared magnitudes, of which the first `count_` are valid
};

}  // namespace vo
