#pragma once

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// Encodes optical flow, px, as the bytes of Middlebury's .flo format (Baker et al., IJCV 2011).
std::string encode_flow(const cv::Mat_<cv::Vec2f>& flow);

/// Reads optical flow, px, from a .flo file. Throws Error naming the file if it is not one.
cv::Mat_<cv::Vec2f> read_flow(const std::filesystem::path& path);

}  // namespace vo
