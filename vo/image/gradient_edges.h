#pragma once

#include "vo/image/edges.h"

namespace vo {

/// Canny's edges with the options' threshold.
EdgeMask canny_edges(const GrayImage& gray, const EdgeOptions& options);

/// Pixels whose gradient is at least the options' strong threshold; with `sobel_thin` only where
/// it is greatest across the edge.
EdgeMask sobel_edges(const GrayImage& gray, const EdgeOptions& options);

}  // namespace vo
