#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// Encodes a float image as the bytes of NumPy's .npy format, version 1.0: '<f4', shape (height,
/// width), or (height, width, 3) of an image with three channels.
std::string encode_npy(const cv::Mat& image);

/// Encodes numbers, row by row, as the bytes of an .npy file, version 1.0: '<f8' of this shape.
std::string encode_npy(std::span<const double> values, std::span<const std::size_t> shape);

/// Reads an image as `encode_npy` writes it; throws Error naming the file for anything else.
cv::Mat read_npy(const std::filesystem::path& path);

}  // namespace vo
