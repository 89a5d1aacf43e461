#pragma once

#include "vo/core/image.h"

namespace vo {

/// Halves an image by cubic interpolation (Keys, Cubic convolution interpolation for digital image
/// processing, 1981, with a = -0.75), pixels beyond the border being those at it: cv::resize with
/// INTER_CUBIC, whose rounding is that of the processor's vectors and fused instructions. This one
/// rounds alike on all of them. An empty image gives an empty one.
void halve_cubic(const DepthImage& depth, DepthImage& half);

}  // namespace vo
