#pragma once

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// Reads an image of linear light in Radiance's format RGBE (.hdr; Ward, Real pixels, Graphics Gems
/// II, 1991) as RGB, in the units of its header's EXPOSURE. Throws Error naming the file and what
/// is wrong with it; of the orders of pixels it reads `-Y HEIGHT +X WIDTH`, which everybody writes.
cv::Mat_<cv::Vec3f> read_rgbe(const std::filesystem::path& path);

/// Returns an RGB image of linear light as the bytes of an RGBE file, whose largest channel of each
/// pixel has 8 bits.
std::string encode_rgbe(const cv::Mat_<cv::Vec3f>& image);

}  // namespace vo
