#pragma once

#include <memory>

#include "vo/core/image.h"
#include "vo/edges/edge_options.h"
#include "vo/edges/gradient_edges.h"

namespace vo {

class StructuredForest;

/// An edge detector that is ready to use: what is slow to prepare, a forest's model, is loaded once
/// and shared by copies.
class EdgeFinder {
 public:
  /// Throws Error where the options or the model file cannot be used.
  explicit EdgeFinder(EdgeOptions options);

  /// Writes the edges of an image, 255, to `edges`. Canny writes into its memory if no other image
  /// shares it and reuses its working memory; the other detectors replace it.
  void detect(const GrayImage& gray, EdgeMask& edges);

 private:
  EdgeOptions options_;
  CannyEdges canny_;
  std::shared_ptr<const StructuredForest> forest_;  ///< null for all other detectors
};

/// Returns the edges of a single image; throws Error where the options or the model file cannot be
/// used.
EdgeMask detect_edges(const GrayImage& gray, const EdgeOptions& options);

}  // namespace vo
