#pragma once

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// Encodes an image of one or three float channels as a TIFF: little-endian, one strip, not
/// compressed.
std::string encode_float_tiff(const cv::Mat& image);

/// Reads what `encode_float_tiff` writes; throws Error naming the file for anything else.
cv::Mat read_float_tiff(const std::filesystem::path& path);

}  // namespace vo
