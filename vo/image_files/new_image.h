#pragma once

#include <filesystem>

#include <opencv2/core.hpp>

namespace vo {

/// Returns an image of the size that a file's header states, with undefined pixels. Throws Error
/// naming the file: `input` if the size is none or beyond 16384 px, `temporary` if there is not
/// enough memory.
cv::Mat new_image(cv::Size size, int type, const std::filesystem::path& path);

/// Returns an image of linear light, RGB, as `new_image` does. Throws Error naming the file, too,
/// beyond 2^26 px, 800 MB, which a short file may stand for.
cv::Mat_<cv::Vec3f> new_light_image(cv::Size size, const std::filesystem::path& path);

}  // namespace vo
