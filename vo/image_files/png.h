#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <opencv2/core.hpp>

namespace vo {

/// Reads a PNG as 8-bit grey (CV_8UC1), 8-bit colour (CV_8UC3, BGR; palette resolved, alpha
/// dropped) or 16-bit grey (CV_16UC1). Throws Error naming the file when it is missing, truncated
/// or damaged.
cv::Mat read_png(const std::filesystem::path& path);

/// Returns whether bytes begin as those of a PNG do.
bool is_png(std::string_view bytes);

/// Decodes a PNG as `read_png` reads it; `path` is the file that the bytes are of.
cv::Mat decode_png(std::string_view bytes, const std::filesystem::path& path);

/// Decodes a PNG of any kind as 8-bit red, green, blue and alpha, 255 where it has none; 16-bit
/// values are rounded to 8 bits. Throws as `read_png` does.
cv::Mat_<cv::Vec4b> decode_png_rgba(std::string_view bytes, const std::filesystem::path& path);

/// Encodes an image of type CV_8UC1, CV_8UC3 (BGR) or CV_16UC1 as the bytes of a PNG file.
std::string encode_png(const cv::Mat& image);

}  // namespace vo
