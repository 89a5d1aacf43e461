#pragma once

#include <numeric>
#include <vector>

#include "vo/structured_forest/structured_forest.h"

namespace support {

/// Two trees, one of them asked per patch, both: below the threshold of a feature no edges, else
/// these bins.
inline vo::StructuredForest small_forest(int feature, float threshold,
                                         const std::vector<int>& bins) {
  vo::ForestParameters parameters;
  parameters.trees = 2;
  parameters.trees_to_evaluate = 1;
  const int size = static_cast<int>(bins.size());
  vo::ForestNodes nodes{.children = {2, 0, 0, 2, 0, 0},
                        .feature_ids = {feature, 0, 0, feature, 0, 0},
                        .thresholds = {threshold, 0, 0, threshold, 0, 0},
                        .edge_boundaries = {0, 0, 0, size, size, size, 2 * size},
                        .edge_bins = bins};
  nodes.edge_bins.insert(nodes.edge_bins.end(), bins.begin(), bins.end());
  return {parameters, nodes};
}

inline std::vector<int> all_bins() {
  std::vector<int> bins(256);
  std::iota(bins.begin(), bins.end(), 0);
  return bins;
}

}  // namespace support
