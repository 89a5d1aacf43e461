#pragma once

#include <array>

#include "vo/core/image.h"
#include "vo/core/instruction_set.h"
#include "vo/edges/gradient_row.h"
#include "vo/edges/hysteresis.h"

namespace vo {

/// Edge detector of Canny, "A computational approach to edge detection", PAMI 1986, with thresholds
/// for SobelMagnitudes: maxima across the edge, in one of four directions, that are above `strong`,
/// and those above `weak` that are connected with them. It finds the pixels that cv::Canny finds
/// with the L2 gradient, faster: gradients are computed row by row and never leave the cache,
/// maxima are found without branches.
class Canny {
 public:
  /// Writes the edges, 255, of an image into `edges`, which is reallocated only if it has another
  /// size. Working memory is reused from image to image.
  void find(const ByteImage& image, double weak, double strong, InstructionSet set,
            EdgeMask& edges);

 private:
  std::array<GradientRow, 3> rows_;
  Hysteresis hysteresis_;
};

}  // namespace vo
