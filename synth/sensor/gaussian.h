#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "vo/core/random_field.h"

namespace synth {

/// The half of a Gaussian kernel from its middle outwards, to 4 sigma; the whole sums to 1.
std::vector<float> gaussian_kernel(double sigma_px);

/// The light of each pixel spread over its neighbourhood; what lies beyond the image's border is
/// taken to be like the border.
cv::Mat_<cv::Vec3f> blurred(const cv::Mat_<cv::Vec3f>& image, double sigma_px);

/// Normal noise of mean 0 and variance 1 whose pixels are correlated like white noise under a
/// Gaussian blur; white at 0.
cv::Mat_<float> noise_image(const cv::Size& size, double correlation_px,
                            const vo::RandomField& random);

}  // namespace synth
