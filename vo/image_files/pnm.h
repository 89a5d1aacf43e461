#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <opencv2/core.hpp>

namespace vo {

/// Returns whether bytes begin as those of a binary portable grey map ("P5") or pixel map ("P6").
bool is_pnm(std::string_view bytes);

/// Decodes a binary portable map: grey of 8 bits (CV_8UC1), of 16 bits (CV_16UC1) where its
/// greatest value is above 255, or colour of 8 bits (CV_8UC3, BGR). Values of 8 bits are scaled to
/// 255. Throws Error naming `path`, the file that the bytes are of.
cv::Mat decode_pnm(std::string_view bytes, const std::filesystem::path& path);

/// Encodes an image of type CV_8UC1, CV_16UC1 or CV_8UC3 (BGR) as a binary portable map.
std::string encode_pnm(const cv::Mat& image);

}  // namespace vo
