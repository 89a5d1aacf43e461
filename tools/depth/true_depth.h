#pragma once

#include "vo/core/image.h"

namespace tools {

/// Returns the true inverse depth, 1/m, in a 3x3 window that is nearest to the estimate; 0 if there
/// is none. An edge between a near and a far surface belongs to the near one, wherever its pixel
/// is.
double nearest_true_inverse_depth(const vo::DepthImage& depth, cv::Point pixel, double estimate);

}  // namespace tools
