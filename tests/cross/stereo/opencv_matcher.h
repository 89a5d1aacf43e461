#pragma once

#include <opencv2/core.hpp>

#ifdef EDVO_HAS_CALIB3D
#include <opencv2/calib3d.hpp>

namespace support {

inline constexpr int kDisparities = 64;  ///< px, which the matcher searches

/// Returns the disparity that OpenCV's semi-global matcher finds, px, below 0 where it finds none.
inline cv::Mat_<float> matched(const cv::Mat_<std::uint8_t>& left,
                               const cv::Mat_<std::uint8_t>& right) {
  constexpr int kBlock = 5;
  constexpr double kUnitsPerPixel = 16;
  const auto matcher =
      cv::StereoSGBM::create(0, kDisparities, kBlock, 8 * kBlock * kBlock, 32 * kBlock * kBlock, 1,
                             0, 10, 100, 2, cv::StereoSGBM::MODE_HH);
  cv::Mat found;
  matcher->compute(left, right, found);
  cv::Mat_<float> disparity;
  found.convertTo(disparity, CV_32F, 1 / kUnitsPerPixel);
  return disparity;
}

}  // namespace support
#endif
