#pragma once

#include "tools/point_cloud/point_cloud.h"
#include "vo/mapping/depth_map.h"

namespace tools {

/// Returns a picture of the confident hypotheses: true depth | estimated depth | relative error,
/// each with a colour bar. Estimates are divided by `scale` first.
cv::Mat_<cv::Vec3b> draw_depth_map(const vo::DepthMap& map, const vo::DepthImage& true_depth,
                                   double scale);

/// Depth images of the host's size, filled at the confident hypotheses that have a true depth.
struct SparseDepths {
  vo::DepthImage estimate;  ///< m; inverse depths are divided by the scale first
  vo::DepthImage truth;     ///< true depth, m
};

SparseDepths sparse_depths(const vo::DepthMap& map, const vo::DepthImage& true_depth, double scale);

/// Returns the confident hypotheses as points in the world with the host's grey.
EdgeCloud cloud_of(const vo::DepthMap& map, const vo::SE3& T_world_host);

}  // namespace tools
