#pragma once

#include <filesystem>
#include <string>

#include "vo/core/image.h"

namespace vo {

/// A float image as the bytes of NumPy's .npy format, version 1.0: shape (height, width), '<f4'.
std::string encode_npy(const cv::Mat_<float>& image);

/// Reads what `encode_npy` writes; throws Error naming the file for anything else.
cv::Mat_<float> read_npy(const std::filesystem::path& path);

}  // namespace vo
