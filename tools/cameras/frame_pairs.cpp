#include "tools/cameras/frame_pairs.h"

#include <cmath>
#include <utility>

namespace tools {

void FramePairs::add_colour(double timestamp, cv::Mat image) {
  unpaired_ += colour_.has_value() ? 1 : 0;
  colour_ = Colour{timestamp, std::move(image)};
}

void FramePairs::add_depth(double timestamp, vo::DepthImage depth) {
  unpaired_ += depth_.has_value() ? 1 : 0;
  depth_ = Depth{timestamp, std::move(depth)};
}

std::optional<vo::RgbdFrame> FramePairs::take() {
  if (!colour_ || !depth_) {
    return std::nullopt;
  }
  if (std::abs(colour_->timestamp - depth_->timestamp) > max_time_difference_) {
    ++unpaired_;
    if (colour_->timestamp < depth_->timestamp) {
      colour_.reset();
    } else {
      depth_.reset();
    }
    return std::nullopt;
  }
  vo::RgbdFrame frame{colour_->timestamp, std::move(colour_->image), std::move(depth_->image),
                      depth_->timestamp - colour_->timestamp};
  colour_.reset();
  depth_.reset();
  return frame;
}

}  // namespace tools
