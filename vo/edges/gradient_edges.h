#pragma once

#include <vector>

#include "vo/core/image.h"
#include "vo/edges/canny.h"
#include "vo/edges/edge_options.h"
#include "vo/edges/sobel_magnitudes.h"

namespace vo {

/// Canny's edge detector with the threshold of EdgeOptions; it reuses its memory from image to
/// image.
class CannyEdges {
 public:
  void find(const GrayImage& gray, const EdgeOptions& options, EdgeMask& edges);

 private:
  std::vector<uchar> bytes_;  ///< pixels of the image, 0..255
  SobelMagnitudes magnitudes_;
  Canny canny_;
};

/// Returns the pixels whose gradient is at least the options' strong threshold; with `sobel_thin`
/// only where it is greatest across the edge.
EdgeMask sobel_edges(const GrayImage& gray, const EdgeOptions& options);

}  // namespace vo
