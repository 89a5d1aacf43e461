#pragma once

#include <string>
#include <vector>

#include "vo/core/image.h"
#include "vo/structured_forest/forest_features.h"

namespace vo {

/// The trees of a structured forest, one after the other, all with equally many nodes. Node k of a
/// tree continues at its node children[k] - 1 where the feature is below the threshold, else at
/// children[k]; 0 is a leaf. A leaf's edges are the pixels edge_bins[edge_boundaries[k]] up to
/// edge_bins[edge_boundaries[k + 1]] of the predicted patch, counted down its columns.
struct ForestNodes {
  std::vector<int> children;
  std::vector<int> feature_ids;
  std::vector<float> thresholds;
  std::vector<int> edge_boundaries;  ///< one more element than nodes
  std::vector<int> edge_bins;
};

/// Edge detector of Dollar & Zitnick (ICCV 2013): each patch falls through some of the trees, and
/// the edges of the leaves it reaches are averaged. The result equals that of OpenCV's
/// ximgproc::StructuredEdgeDetection for the same model.
class StructuredForest {
 public:
  /// Throws Error unless every index is in range and every path ends at a leaf.
  StructuredForest(const ForestParameters& parameters, ForestNodes nodes);

  const ForestParameters& parameters() const { return parameters_; }
  const ForestNodes& nodes() const { return nodes_; }

  /// Returns how likely an edge runs through each pixel, about 0..1, for `rgb` in 0..1; 0
  /// everywhere if the image is too small for a patch.
  cv::Mat_<float> edge_strength(const cv::Mat_<cv::Vec3f>& rgb) const;

 private:
  int leaf(int tree, const FeatureIndex& index, const float* regular,
           const float* similarity) const;
  void vote(int leaf, const cv::Point& corner, float weight, cv::Mat_<float>& strength) const;

  ForestParameters parameters_;
  ForestNodes nodes_;
  int nodes_per_tree_;
};

/// Returns a ColorImage, ByteImage or GrayImage as RGB in 0..1; grey in all three channels.
cv::Mat_<cv::Vec3f> to_rgb(const cv::Mat& image);

/// Returns the edge strength where it is greatest across the edge, 0 elsewhere. The forest runs on
/// the image enlarged by `scale`, which tells apart lines that lie close together.
cv::Mat_<float> thin_edge_strength(const StructuredForest& forest, const cv::Mat_<cv::Vec3f>& rgb,
                                   int scale);

/// Returns the pixels where `thin_edge_strength` is at least `least_strength`.
EdgeMask forest_edges(const StructuredForest& forest, const cv::Mat_<cv::Vec3f>& rgb, int scale,
                      double least_strength);

}  // namespace vo
