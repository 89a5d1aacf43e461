#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

namespace vo {

/// Returns a hash of 64 bits of an image's bytes, to tell an image from its repetition; 0 for an
/// empty one. It allocates nothing, and is the same on any machine of the same byte order.
std::uint64_t fingerprint(const cv::Mat& image);

}  // namespace vo
