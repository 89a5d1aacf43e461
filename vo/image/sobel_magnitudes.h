#pragma once

#include <vector>

#include "vo/core/image.h"
#include "vo/core/instruction_set.h"

namespace vo {

/// The gradient's Euclidean magnitudes, of 3x3 Sobel kernels on intensities 0..255, in every
/// `row_step`-th row; the border is replicated.
class SobelMagnitudes {
 public:
  static constexpr int kGreatest = 1442;  ///< floor(1020 sqrt(2))

  SobelMagnitudes(const ByteImage& image, int row_step, InstructionSet set);

  int count() const { return static_cast<int>(squares_.size()); }
  int count_below(int magnitude) const;

 private:
  InstructionSet set_;
  std::vector<int> squares_;
};

}  // namespace vo
