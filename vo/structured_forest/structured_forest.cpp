#include "vo/structured_forest/structured_forest.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"
#include "vo/structured_forest/edge_thinning.h"
#include "vo/structured_forest/triangle_filter.h"

namespace vo {
namespace {

void check_sizes(const ForestParameters& parameters, const ForestNodes& nodes) {
  const std::size_t count = nodes.children.size();
  require(count > 0 && count % static_cast<std::size_t>(parameters.trees) == 0,
          "childs: expected as many nodes in each of ", parameters.trees, " trees, got ", count,
          " in all");
  require(nodes.feature_ids.size() == count, "featureIds: expected ", count, " elements, got ",
          nodes.feature_ids.size());
  require(nodes.thresholds.size() == count, "thresholds: expected ", count, " elements, got ",
          nodes.thresholds.size());
  require(nodes.edge_boundaries.size() > count, "edgeBoundaries: expected ", count + 1,
          " elements, got ", nodes.edge_boundaries.size());
}

void check_splits(const ForestNodes& nodes, int nodes_per_tree, int features) {
  for (std::size_t i = 0; i < nodes.children.size(); ++i) {
    const int child = nodes.children[i];
    const int own = static_cast<int>(i) % nodes_per_tree;
    if (child == 0) {
      continue;
    }
    require(child - 1 > own && child < nodes_per_tree, "childs[", i,
            "]: expected 0 or a later node of its tree of ", nodes_per_tree, ", got ", child);
    require(nodes.feature_ids[i] >= 0 && nodes.feature_ids[i] < features, "featureIds[", i,
            "]: expected 0 to ", features - 1, ", got ", nodes.feature_ids[i]);
    require(std::isfinite(nodes.thresholds[i]), "thresholds[", i, "]: expected a finite number");
  }
}

void check_edges(const ForestNodes& nodes, int bins) {
  const std::size_t count = nodes.children.size() + 1;
  const int last = static_cast<int>(nodes.edge_bins.size());
  for (std::size_t i = 0; i < count; ++i) {
    const int least = i == 0 ? 0 : nodes.edge_boundaries[i - 1];
    require(nodes.edge_boundaries[i] >= least && nodes.edge_boundaries[i] <= last,
            "edgeBoundaries[", i, "]: expected ", least, " to ", last, ", got ",
            nodes.edge_boundaries[i]);
  }
  for (std::size_t i = 0; i < nodes.edge_bins.size(); ++i) {
    require(nodes.edge_bins[i] >= 0 && nodes.edge_bins[i] < bins, "edgeBins[", i,
            "]: expected 0 to ", bins - 1, ", got ", nodes.edge_bins[i]);
  }
}

}  // namespace

StructuredForest::StructuredForest(const ForestParameters& parameters, ForestNodes nodes)
    : parameters_(parameters), nodes_(std::move(nodes)) {
  parameters_.validate();
  check_sizes(parameters_, nodes_);
  nodes_per_tree_ = static_cast<int>(nodes_.children.size()) / parameters_.trees;
  check_splits(nodes_, nodes_per_tree_, feature_count(parameters_));
  check_edges(nodes_, parameters_.bins() * parameters_.channels());
}

int StructuredForest::leaf(int tree, const FeatureIndex& index, const float* regular,
                           const float* similarity) const {
  const int root = tree * nodes_per_tree_;
  auto node = static_cast<std::size_t>(root);
  while (nodes_.children[node] != 0) {
    const bool is_below =
        index.value(nodes_.feature_ids[node], regular, similarity) < nodes_.thresholds[node];
    node = static_cast<std::size_t>(root + nodes_.children[node] - (is_below ? 1 : 0));
  }
  return static_cast<int>(node);
}

void StructuredForest::vote(int leaf, const cv::Point& corner, float weight,
                            cv::Mat_<float>& strength) const {
  const int end = nodes_.edge_boundaries[static_cast<std::size_t>(leaf) + 1];
  for (int i = nodes_.edge_boundaries[static_cast<std::size_t>(leaf)]; i < end; ++i) {
    const int bin = nodes_.edge_bins[static_cast<std::size_t>(i)] % parameters_.bins();
    strength(corner.y + bin % parameters_.inner_size, corner.x + bin / parameters_.inner_size) +=
        weight;
  }
}

cv::Mat_<float> StructuredForest::edge_strength(const cv::Mat_<cv::Vec3f>& rgb) const {
  const ForestParameters& p = parameters_;
  cv::Mat_<float> strength(rgb.size(), 0.0F);
  const cv::Size grid = patch_grid(rgb.size(), p);
  if (grid.empty()) {
    return strength;
  }
  const ForestFeatures features = forest_features(rgb, p);
  const FeatureIndex index(p, features.regular.step1());
  const float weight = 2 * static_cast<float>(p.stride * p.stride) /
                       static_cast<float>(p.bins() * p.trees_to_evaluate);
  for (int i = 0; i < grid.height; ++i) {
    const int row = i * p.stride / p.shrink;
    for (int j = 0; j < grid.width; ++j) {
      const int offset = j * p.stride / p.shrink * p.channels();
      for (int k = 0; k < p.trees_to_evaluate; ++k) {
        const int tree = ((i + j) % (2 * p.trees_to_evaluate) + k) % p.trees;
        const int reached = leaf(tree, index, features.regular.ptr<float>(row) + offset,
                                 features.similarity.ptr<float>(row) + offset);
        vote(reached, {j * p.stride, i * p.stride}, weight, strength);
      }
    }
  }
  return smoothed_by_triangle(strength, 1);
}

cv::Mat_<cv::Vec3f> to_rgb(const cv::Mat& image) {
  cv::Mat rgb;
  cv::cvtColor(image, rgb, image.channels() == 3 ? cv::COLOR_BGR2RGB : cv::COLOR_GRAY2RGB);
  cv::Mat_<cv::Vec3f> scaled;
  rgb.convertTo(scaled, CV_32F, image.depth() == CV_8U ? 1.0 / 255 : 1.0);
  return scaled;
}

cv::Mat_<float> thin_edge_strength(const StructuredForest& forest, const cv::Mat_<cv::Vec3f>& rgb,
                                   int scale) {
  constexpr int kRadius = 1;  // px
  cv::Mat enlarged = rgb;
  if (scale > 1) {
    cv::resize(rgb, enlarged, rgb.size() * scale, 0, 0, cv::INTER_LINEAR);
  }
  cv::Mat_<float> strength = forest.edge_strength(enlarged);
  if (scale > 1) {
    cv::resize(strength, strength, rgb.size(), 0, 0, cv::INTER_AREA);
  }
  return thinned(strength, across_ridges(strength, kRadius), kRadius);
}

EdgeMask forest_edges(const StructuredForest& forest, const cv::Mat_<cv::Vec3f>& rgb, int scale,
                      double least_strength) {
  cv::Mat edges = thin_edge_strength(forest, rgb, scale) >= least_strength;
  return edges;
}

}  // namespace vo
