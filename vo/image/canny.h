#pragma once

#include "vo/core/image.h"
#include "vo/core/instruction_set.h"

namespace vo {

/// Canny, "A computational approach to edge detection", PAMI 1986, with thresholds for
/// SobelMagnitudes: maxima across the edge, in one of four directions, that are above `strong`, and
/// those above `weak` that are connected with them. The same pixels as cv::Canny with the L2 gradient finds, faster:
/// gradients are computed row by row and never leave the cache, maxima are found without branches.
EdgeMask canny(const ByteImage& image, double weak, double strong, InstructionSet set);

}  // namespace vo
