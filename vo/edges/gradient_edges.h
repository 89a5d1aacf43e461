#pragma once

#include <vector>

#include "vo/core/image.h"
#include "vo/edges/canny.h"
#include "vo/edges/edge_options.h"
#include "vo/edges/sobel_magnitudes.h"

namespace vo {

/// Canny's edges with the options' threshold, one image after the other in the same memory.
class CannyEdges {
 public:
  void find(const GrayImage& gray, const EdgeOptions& options, EdgeMask& edges);

 private:
  std::vector<uchar> bytes_;  ///< 0..255, of the image
  SobelMagnitudes magnitudes_;
  Canny canny_;
};

/// Pixels whose gradient is at least the options' strong threshold; with `sobel_thin` only where
/// it is greatest across the edge.
EdgeMask sobel_edges(const GrayImage& gray, const EdgeOptions& options);

}  // namespace vo
