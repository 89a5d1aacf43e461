#pragma once

#include <vector>

#include "vo/core/image.h"

namespace vo {

/// Which depths are good for a point.
struct UsableDepth {
  float nearest = 0;         ///< m
  float farthest = 0;        ///< m
  int step_radius = 0;       ///< px; not this near to a step between measured depths, 0 is no limit
  float step_ratio = 1.05F;  ///< of depths that are a step

  bool is_in_range(float depth) const { return depth >= nearest && depth <= farthest; }
};

/// The mask's pixels whose depth is usable, in scan order; `pixels` is overwritten.
void find_usable_pixels(const DepthImage& depth, const EdgeMask& mask, const UsableDepth& usable,
                        std::vector<cv::Point>& pixels);

}  // namespace vo
