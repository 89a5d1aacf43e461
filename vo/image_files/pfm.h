#pragma once

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// Encodes an image of one ("Pf") or three ("PF") float channels as a little-endian portable float
/// map.
std::string encode_pfm(const cv::Mat& image);

/// Reads what `encode_pfm` writes; throws Error naming the file for anything else.
cv::Mat read_pfm(const std::filesystem::path& path);

}  // namespace vo
