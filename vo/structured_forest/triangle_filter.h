#pragma once

#include <opencv2/core.hpp>

namespace vo {

/// Filters by a separable triangle of whole radius, px, as piotr's toolbox has it: 0 returns the
/// image itself, 1 is [1 2 1] / 4, and r is [1 2 ... r + 1 ... 2 1] / (r + 1)^2. Any number of
/// channels.
cv::Mat smoothed_by_triangle(const cv::Mat& image, int radius);

}  // namespace vo
