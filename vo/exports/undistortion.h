#pragma once

#include <cstddef>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"

namespace vo {

/// Makes of a lens's images those of a perfect one of the same size. The focal lengths grow by one
/// factor, and the principal point moves if it must, just so far that every pixel is within the
/// lens's image: none is invented, and what lies outside is lost. The factor is at least 1/2, which
/// leaves a fisheye's middle with half its resolution and takes off its rim.
class Undistortion {
 public:
  /// Throws Error if no such camera exists.
  explicit Undistortion(const PinholeCamera& lens);

  const PinholeCamera& camera() const { return camera_; }  ///< without distortion
  std::size_t holes() const {
    return holes_;
  }  ///< pixels that the lens does not image: 0, no depth

  /// Returns the frame that `camera` would take: bilinear colour; depth of the nearest pixel, which
  /// is along the same axis.
  RgbdFrame apply(const RgbdFrame& frame) const;

 private:
  PinholeCamera camera_;
  cv::Mat_<cv::Vec2f> origins_;  ///< pixel of the lens's image that each pixel shows
  cv::Mat_<uchar> is_hole_;      ///< 255 or 0
  std::size_t holes_ = 0;
};

}  // namespace vo
