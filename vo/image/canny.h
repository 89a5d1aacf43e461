#pragma once

#include <vector>

#include "vo/core/image.h"
#include "vo/core/instruction_set.h"

namespace vo {

/// Pixels by the whole part of their gradient's Euclidean magnitude, of 3x3 Sobel kernels on
/// intensities 0..255, in every `row_step`-th row; the border is replicated.
std::vector<int> sobel_magnitude_histogram(const ByteImage& image, int row_step,
                                           InstructionSet set);

/// Canny, "A computational approach to edge detection", PAMI 1986, with the same gradient: maxima
/// across the edge, in one of four directions, that are above `strong`, and those above `weak` that
/// are connected with them. The same pixels as cv::Canny with the L2 gradient finds, faster:
/// gradients are computed row by row and never leave the cache, maxima are found without branches.
EdgeMask canny(const ByteImage& image, double weak, double strong, InstructionSet set);

}  // namespace vo
