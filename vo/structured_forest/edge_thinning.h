#pragma once

#include "vo/core/image.h"

namespace vo {

/// Returns the strength where it is greatest within `radius` px along `across`, unit vectors (du,
/// dv), and 0 elsewhere. Of two neighbours of equal strength one remains.
cv::Mat_<float> thinned(const cv::Mat_<float>& strength, const GradientImage& across, int radius);

/// Returns the unit vectors across the ridges of an image: the direction of the most negative
/// second derivative after smoothing with a triangle of this radius, px.
GradientImage across_ridges(const cv::Mat_<float>& strength, int radius);

}  // namespace vo
