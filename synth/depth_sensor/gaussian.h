#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "vo/core/random_field.h"

namespace synth {

/// Returns one half of a Gaussian kernel, from its middle to 4 sigma; the whole kernel sums to 1.
std::vector<float> gaussian_kernel(double sigma_px);

/// Returns the image blurred by a Gaussian; the image's border is continued beyond it.
cv::Mat_<cv::Vec3f> blurred(const cv::Mat_<cv::Vec3f>& image, double sigma_px);

/// Returns Gaussian noise of mean 0 and variance 1 whose pixels are correlated like white noise
/// under a Gaussian blur; white at 0.
cv::Mat_<float> noise_image(const cv::Size& size, double correlation_px,
                            const vo::RandomField& random);

}  // namespace synth
