#include "vo/edges/edges.h"

#include <utility>

#include "vo/core/error.h"
#include "vo/edges/laplacian_edges.h"
#include "vo/structured_forest/structured_forest.h"
#include "vo/structured_forest/structured_forest_file.h"

namespace vo {

void EdgeOptions::validate() const {
  require(percentile > 0 && percentile < 100, "edges.percentile: expected 0 to 100, got ",
          percentile);
  require(weak_ratio > 0 && weak_ratio <= 1, "edges.weak_ratio: expected 0 to 1, got ", weak_ratio);
  require(strong > 0 && floor > 0, "edges: expected thresholds above 0");
  require(target_count > 0, "edges.target_count: expected above 0, got ", target_count);
  require(log_sigma >= 0.5 && log_sigma <= 10, "edges.log_sigma: expected 0.5 to 10 px, got ",
          log_sigma);
  require(log_strength > 0, "edges.log_strength: expected above 0, got ", log_strength);
  require(forest_scale >= 1 && forest_scale <= 4, "edges.forest_scale: expected 1 to 4, got ",
          forest_scale);
  require(forest_strength > 0 && forest_strength < 1,
          "edges.forest_strength: expected 0 to 1, got ", forest_strength);
  require(detector != EdgeDetector::structured_forest || !forest_model.empty(),
          "edges.forest_model: expected a model file for the detector structured_forest");
}

EdgeFinder::EdgeFinder(EdgeOptions options) : options_(std::move(options)) {
  options_.validate();
  if (options_.detector == EdgeDetector::structured_forest) {
    forest_ = std::make_shared<StructuredForest>(read_structured_forest(options_.forest_model));
  }
}

void EdgeFinder::detect(const GrayImage& gray, EdgeMask& edges) {
  switch (options_.detector) {
    case EdgeDetector::log:
      edges = laplacian_edges(gray, options_);
      break;
    case EdgeDetector::sobel:
      edges = sobel_edges(gray, options_);
      break;
    case EdgeDetector::structured_forest:
      edges = forest_edges(*forest_, to_rgb(gray), options_.forest_scale, options_.forest_strength);
      break;
    default:
      make_writable(edges, gray.size());
      canny_.find(gray, options_, edges);
  }
}

EdgeMask detect_edges(const GrayImage& gray, const EdgeOptions& options) {
  EdgeMask edges;
  EdgeFinder(options).detect(gray, edges);
  return edges;
}

}  // namespace vo
