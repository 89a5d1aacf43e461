#pragma once

#include <filesystem>

#include <opencv2/core.hpp>

namespace vo {

/// Reads an image that is a PNG, a JPEG or a portable grey or pixel map, which its first bytes say,
/// as 8-bit grey (CV_8UC1), 8-bit colour (CV_8UC3, BGR) or, of PNG and grey maps alone, 16-bit grey
/// (CV_16UC1). Throws Error naming the file if it is missing, truncated, damaged or none of these.
cv::Mat read_image(const std::filesystem::path& path);

}  // namespace vo
