#pragma once

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// Encodes a float image as the bytes of NumPy's .npy format, version 1.0: '<f4', shape (height,
/// width), or (height, width, 3) of an image with three channels.
std::string encode_npy(const cv::Mat& image);

/// Reads what `encode_npy` writes; throws Error naming the file for anything else.
cv::Mat read_npy(const std::filesystem::path& path);

}  // namespace vo
