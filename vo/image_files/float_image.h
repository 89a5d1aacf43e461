#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>

#include <opencv2/core.hpp>

namespace vo {

enum class FloatFormat {
  npy,   ///< NumPy: shape (height, width) or (height, width, 3)
  pfm,   ///< Portable float map, rows from the bottom up
  tiff,  ///< 32-bit float samples, one strip, not compressed
};

constexpr auto enum_names(FloatFormat) {
  return std::array{std::pair{FloatFormat::npy, "npy"}, std::pair{FloatFormat::pfm, "pfm"},
                    std::pair{FloatFormat::tiff, "tiff"}};
}

/// Encodes an image of one or three float channels as the bytes of a little-endian file.
std::string encode_float_image(const cv::Mat& image, FloatFormat format);

/// Reads a float image in the format of the path's extension, .npy, .pfm, .tiff or .tif. Throws
/// Error naming the file if it cannot be read.
cv::Mat read_float_image(const std::filesystem::path& path);

}  // namespace vo
