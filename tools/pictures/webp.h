#pragma once

#include <string>

#include <opencv2/core.hpp>

namespace tools {

/// Returns a lossy WebP file of a colour picture (BGR); quality 0..100. Throws vo::Error on
/// failure.
std::string encode_webp(const cv::Mat_<cv::Vec3b>& picture, double quality);

/// Returns a lossless WebP file of a picture (BGRA). Throws vo::Error on failure.
std::string encode_webp_lossless(const cv::Mat_<cv::Vec4b>& picture);

}  // namespace tools
