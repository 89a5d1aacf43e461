#pragma once

#include "vo/core/image.h"

namespace tools {

/// The true inverse depth in 3x3 that is nearest to the estimate, 1/m; 0 where there is none. An
/// edge between a near and a far surface belongs to the near one, wherever its pixel is.
double nearest_true_inverse_depth(const vo::DepthImage& depth, cv::Point pixel, double estimate);

}  // namespace tools
