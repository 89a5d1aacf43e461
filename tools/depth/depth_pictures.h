#pragma once

#include <string>

#include "vo/mapping/depth_map.h"

namespace tools {

/// The confident hypotheses beside the true depth: true | estimated | relative error, each with a
/// colour bar. Estimates are divided by `scale` first.
cv::Mat_<cv::Vec3b> draw_depth_map(const vo::DepthMap& map, const vo::DepthImage& true_depth,
                                   double scale);

/// Depth images of the host's size with depth at the confident hypotheses that have a truth.
struct SparseDepths {
  vo::DepthImage estimate;  ///< m, inverse depths divided by a scale first
  vo::DepthImage truth;     ///< m
};

SparseDepths sparse_depths(const vo::DepthMap& map, const vo::DepthImage& true_depth, double scale);

/// The confident hypotheses as points in the world with the host's grey, PLY (ASCII).
std::string as_ply(const vo::DepthMap& map, const vo::SE3& T_world_host);

}  // namespace tools
