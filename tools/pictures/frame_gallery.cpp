#include "tools/pictures/frame_gallery.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include <opencv2/imgproc.hpp>

#include "tools/pictures/pictures.h"

namespace tools {
namespace {

vo::DepthImage inverse_of(const vo::DepthImage& depth, cv::Size size) {
  vo::DepthImage inverse;
  cv::divide(1.0, depth, inverse);
  inverse.setTo(0, depth <= 0);
  vo::DepthImage fitting;
  cv::resize(inverse, fitting, size, 0, 0, cv::INTER_NEAREST);
  return fitting;
}

/// Removes the elements at odd indices.
template <typename T>
void halve(std::vector<T>& elements) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < elements.size(); i += 2) {
    std::swap(elements[kept++], elements[i]);
  }
  elements.resize(kept);
}

}  // namespace

vo::FrameObserver FrameGallery::observer() {
  return [this](const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                const vo::Tracker& tracker, const vo::TrackingResult& result,
                const vo::StageTimes&) {
    if (seen_++ % stride_ != 0) {
      return;
    }
    const std::size_t index = level_that_fits(pyramid, options_.max_width);
    const vo::PyramidLevel& level = pyramid.levels[index];
    pictures_.push_back(draw_frame(frame, level, aligned_points(tracker, result, index), result));
    views_.push_back(
        scene_view(result.timestamp, level, resized_picture(frame.image, level.intensity.size())));
    thin_out();
  };
}

void FrameGallery::add_inverse_depth(double timestamp, const vo::DepthImage& depth,
                                     const vo::DepthImage& true_depth) {
  const auto found = std::find_if(pictures_.begin(), pictures_.end(),
                                  [&](const FramePictures& p) { return p.timestamp == timestamp; });
  if (found == pictures_.end()) {
    return;
  }
  const vo::DepthImage truth = inverse_of(true_depth, found->size);
  const std::array<double, 2> range = positive_range(truth);
  found->inverse_depth = encoded_values(inverse_of(depth, found->size), range);
  found->inverse_depth_truth = encoded_values(truth, range);
  thin_out();
}

std::size_t FrameGallery::bytes() const {
  return std::transform_reduce(pictures_.begin(), pictures_.end(), std::size_t{0}, std::plus<>(),
                               [](const FramePictures& p) { return p.bytes(); });
}

void FrameGallery::thin_out() {
  while (pictures_.size() > 1 && bytes() > options_.max_bytes) {
    halve(pictures_);
    halve(views_);
    stride_ *= 2;
  }
}

}  // namespace tools
