#pragma once

#include <vector>

#include "vo/core/image.h"

namespace vo {

/// The condition on the depth of a pixel that is to become a point.
struct UsableDepth {
  float nearest = 0;         ///< m
  float farthest = 0;        ///< m
  int step_radius = 0;       ///< px; pixels this near to a depth step are not usable, 0 is no limit
  float step_ratio = 1.05F;  ///< ratio of nearby depths that makes a step

  bool is_in_range(float depth) const { return depth >= nearest && depth <= farthest; }
};

/// Finds the mask's pixels whose depth is usable, in scan order; `pixels` is overwritten.
void find_usable_pixels(const DepthImage& depth, const EdgeMask& mask, const UsableDepth& usable,
                        std::vector<cv::Point>& pixels);

}  // namespace vo
