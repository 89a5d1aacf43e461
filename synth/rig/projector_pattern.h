#pragma once

#include <string>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "vo/rigs/rig.h"

namespace synth {

/// Returns the tangents of half a projector's horizontal and vertical field of view.
Eigen::Vector2d half_extent_of(const vo::RigProjector& projector);

/// Returns the picture of a projector, linear, 0 to 1: of its PNG file, whose values are light and
/// not sRGB (the mean of red, green and blue, of 8 bit, where it has colours), or of random dots. A
/// dot's brightness at a distance r from its centre is cos^2(pi r / (2 d)), d being the diameter
/// where it is half as bright, on a plane across the optical axis; where dots overlap, the
/// brightest counts. Their places are Sobol's sequence, scrambled by the seed. Throws vo::Error
/// naming the projector and, if it has one, the file, for one that is missing, broken or beyond
/// 2^24 px, and for dots so small that their picture would be wider or higher than 4096 px.
cv::Mat_<float> pattern_of(const vo::RigProjector& projector);

/// Returns the bytes of the PNG file of a projector that has one. Throws as `pattern_of` does.
std::string pattern_bytes(const vo::RigProjector& projector);

}  // namespace synth
