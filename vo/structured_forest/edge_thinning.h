#pragma once

#include "vo/core/image.h"

namespace vo {

/// The strength where it is greatest within `radius` px along `across`, unit vectors (du, dv);
/// elsewhere 0. Of two neighbours of the same strength one remains.
cv::Mat_<float> thinned(const cv::Mat_<float>& strength, const GradientImage& across, int radius);

/// The direction across each ridge of an image: that of the most negative second derivative after
/// smoothing with a triangle of this radius, px.
GradientImage across_ridges(const cv::Mat_<float>& strength, int radius);

}  // namespace vo
