#pragma once

#include <memory>

#include "vo/core/image.h"
#include "vo/edges/edge_options.h"
#include "vo/edges/gradient_edges.h"

namespace vo {

class StructuredForest;

/// A detector that is ready: what is slow to prepare, a forest's model, is loaded once. Copies
/// share it.
class EdgeFinder {
 public:
  /// Throws Error where the options or the model file cannot be used.
  explicit EdgeFinder(EdgeOptions options);

  /// In the memory that `edges` has, if nobody else holds that; Canny needs no other from the
  /// second image on.
  void detect(const GrayImage& gray, EdgeMask& edges);

 private:
  EdgeOptions options_;
  CannyEdges canny_;
  std::shared_ptr<const StructuredForest> forest_;  ///< of `structured_forest` only
};

/// The same for a single image.
EdgeMask detect_edges(const GrayImage& gray, const EdgeOptions& options);

}  // namespace vo
