#pragma once

#include <string>

#include <opencv2/core.hpp>

namespace tools {

/// A WebP file of a colour picture (BGR), lossy; quality 0..100.
std::string encode_webp(const cv::Mat_<cv::Vec3b>& picture, double quality);

/// A WebP file of a picture (BGR and alpha) that reads back with the same values.
std::string encode_webp_lossless(const cv::Mat_<cv::Vec4b>& picture);

}  // namespace tools
