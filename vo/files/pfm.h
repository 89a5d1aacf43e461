#pragma once

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// An image of one ("Pf") or three ("PF") float channels as a portable float map, little-endian.
std::string encode_pfm(const cv::Mat& image);

/// Reads what `encode_pfm` writes; throws Error naming the file for anything else.
cv::Mat read_pfm(const std::filesystem::path& path);

}  // namespace vo
