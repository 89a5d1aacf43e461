#pragma once

#include <cstring>

#include <opencv2/core.hpp>

namespace support {

/// Returns whether two images have equal sizes, types and bits; NaN equals itself.
inline bool have_same_pixels(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) {
    return false;
  }
  for (int v = 0; v < a.rows; ++v) {
    if (std::memcmp(a.ptr(v), b.ptr(v), static_cast<std::size_t>(a.cols) * a.elemSize()) != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace support
