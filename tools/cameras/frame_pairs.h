#pragma once

#include <cstddef>
#include <optional>

#include <opencv2/core.hpp>

#include "vo/core/image.h"

namespace tools {

/// Pairs the colour and the depth images of a running camera, which arrive in any order and of
/// which some are missing, as frames: each image is in one frame at most, and of two that cannot be
/// paired the older is given up.
class FramePairs {
 public:
  /// Images are of one frame if their stamps differ by at most this, s.
  explicit FramePairs(double max_time_difference) : max_time_difference_(max_time_difference) {}

  void add_colour(double timestamp, cv::Mat image);
  void add_depth(double timestamp, vo::DepthImage depth);

  /// Returns the frame that the newest images make, with the stamp of its colour, or nothing.
  std::optional<vo::RgbdFrame> take();

  /// Returns how many images were given up, or replaced by a newer one before they made a frame.
  std::size_t unpaired() const { return unpaired_; }

 private:
  struct Colour {
    double timestamp;
    cv::Mat image;
  };
  struct Depth {
    double timestamp;
    vo::DepthImage image;
  };

  double max_time_difference_;
  std::optional<Colour> colour_;
  std::optional<Depth> depth_;
  std::size_t unpaired_ = 0;
};

}  // namespace tools
