#include "tools/pictures/frame_gallery.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include <opencv2/imgproc.hpp>

#include "tools/pictures/pictures.h"
#include "tools/pictures/webp.h"

namespace tools {
namespace {

constexpr double kColourQuality = 40;
constexpr double kValueQuality = 30;
const cv::Vec4b kEdgeColour(66, 228, 240, 255);  // BGRA: Okabe and Ito's yellow

std::size_t level_that_fits(const vo::FramePyramid& pyramid, int max_width) {
  std::size_t level = 0;
  while (level + 1 < pyramid.levels.size() && pyramid.levels[level].intensity.cols > max_width) {
    ++level;
  }
  return level;
}

cv::Mat_<cv::Vec3b> resized(const cv::Mat& image, cv::Size size) {
  cv::Mat_<cv::Vec3b> picture;
  cv::resize(as_picture(image), picture, size, 0, 0, cv::INTER_AREA);
  return picture;
}

std::string edge_overlay(const vo::EdgeMask& edges) {
  cv::Mat_<cv::Vec4b> picture(edges.size(), cv::Vec4b::all(0));
  picture.setTo(kEdgeColour, edges);
  return encode_webp_lossless(picture);
}

ValuePicture encode_values(const cv::Mat_<float>& values, std::array<double, 2> range) {
  return {encode_webp(draw_values(values, range), kValueQuality), range};
}

/// Encodes residuals with few shades, which keeps a lossless picture of dots small.
std::string encode_residuals(const vo::EdgePointLevel& points, const vo::PyramidLevel& level,
                             const vo::SE3& T_cur_ref) {
  constexpr int kShadeBits = 3;
  constexpr uchar kKeptBits = 0xffU << (8 - kShadeBits) & 0xffU;
  cv::Mat_<cv::Vec3b> picture = draw_residuals(points, level, T_cur_ref);
  cv::bitwise_and(picture, cv::Scalar::all(kKeptBits), picture);
  cv::Mat_<cv::Vec4b> opaque;
  cv::cvtColor(picture, opaque, cv::COLOR_BGR2BGRA);
  return encode_webp_lossless(opaque);
}

FramePictures draw_frame(const vo::RgbdFrame& frame, const vo::PyramidLevel& level,
                         const vo::EdgePointLevel& points, const vo::TrackingResult& result) {
  FramePictures pictures;
  pictures.timestamp = result.timestamp;
  pictures.size = level.intensity.size();
  pictures.colour = encode_webp(resized(frame.image, pictures.size), kColourQuality);
  pictures.edges = edge_overlay(level.edges);
  if (!level.depth.empty()) {
    const auto [nearest, farthest] = positive_range(level.depth);
    pictures.depth = encode_values(level.depth, {farthest, nearest});
  }
  if (points.size() > 0) {
    pictures.residual_before = encode_residuals(points, level, result.T_cur_ref_guess);
    pictures.residual_after = encode_residuals(points, level, result.alignment.T_cur_ref);
  }
  return pictures;
}

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

std::size_t FramePictures::bytes() const {
  return colour.size() + edges.size() + residual_before.size() + residual_after.size() +
         depth.webp.size() + inverse_depth.webp.size() + inverse_depth_truth.webp.size();
}

vo::FrameObserver FrameGallery::observer() {
  return [this](const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                const vo::Tracker& tracker, const vo::TrackingResult& result) {
    if (seen_++ % stride_ != 0) {
      return;
    }
    const std::size_t index = level_that_fits(pyramid, options_.max_width);
    const vo::PyramidLevel& level = pyramid.levels[index];
    pictures_.push_back(draw_frame(frame, level, aligned_points(tracker, result, index), result));
    views_.push_back(
        scene_view(result.timestamp, level, resized(frame.image, level.intensity.size())));
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
  found->inverse_depth = encode_values(inverse_of(depth, found->size), range);
  found->inverse_depth_truth = encode_values(truth, range);
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
