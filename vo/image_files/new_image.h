#pragma once

#include <filesystem>

#include <opencv2/core.hpp>

namespace vo {

/// Returns an image of the size that a file's header states, with undefined pixels. Throws Error
/// naming the file: `input` if the size is none or beyond 16384 px, `temporary` if there is not
/// enough memory.
cv::Mat new_image(cv::Size size, int type, const std::filesystem::path& path);

}  // namespace vo
