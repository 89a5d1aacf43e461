#pragma once

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// Optical flow, px, as the bytes of Middlebury's .flo format (Baker et al., IJCV 2011).
std::string encode_flow(const cv::Mat_<cv::Vec2f>& flow);

/// Throws Error naming the file for what is not a .flo file.
cv::Mat_<cv::Vec2f> read_flow(const std::filesystem::path& path);

}  // namespace vo
