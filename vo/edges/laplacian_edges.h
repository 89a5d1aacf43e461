#pragma once

#include "vo/edges/edges.h"

namespace vo {

/// Returns the zero crossings of the Laplacian of the Gaussian-smoothed intensities between a pixel
/// and its right or lower neighbour that step over at least `log_strength`; of the two pixels the
/// one nearer to the crossing is marked.
EdgeMask laplacian_edges(const GrayImage& gray, const EdgeOptions& options);

}  // namespace vo
