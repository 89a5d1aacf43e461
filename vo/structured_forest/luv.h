#pragma once

#include <opencv2/core.hpp>

namespace vo {

/// Returns CIE Luv of RGB in 0..1 (its codes taken as linear light), scaled as in piotr's toolbox:
/// L / 270, (u + 88) / 270, (v + 134) / 270, all about 0..1. Lightness comes from a table of 1024
/// entries, as forests have been trained with.
cv::Mat_<cv::Vec3f> rgb_to_luv(const cv::Mat_<cv::Vec3f>& rgb);

}  // namespace vo
