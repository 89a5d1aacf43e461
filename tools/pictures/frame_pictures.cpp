#include "tools/pictures/frame_pictures.h"

#include <opencv2/imgproc.hpp>

#include "tools/pictures/pictures.h"
#include "tools/pictures/webp.h"

namespace tools {
namespace {

constexpr double kColourQuality = 40;
constexpr double kValueQuality = 30;
const cv::Vec4b kEdgeColour(66, 228, 240, 255);  // BGRA: Okabe and Ito's yellow

std::string edge_overlay(const vo::EdgeMask& edges) {
  cv::Mat_<cv::Vec4b> picture(edges.size(), cv::Vec4b::all(0));
  picture.setTo(kEdgeColour, edges);
  return encode_webp_lossless(picture);
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

}  // namespace

std::size_t FramePictures::bytes() const {
  return colour.size() + edges.size() + residual_before.size() + residual_after.size() +
         depth.webp.size() + inverse_depth.webp.size() + inverse_depth_truth.webp.size();
}

std::size_t level_that_fits(const vo::FramePyramid& pyramid, int max_width) {
  std::size_t level = 0;
  while (level + 1 < pyramid.levels.size() && pyramid.levels[level].intensity.cols > max_width) {
    ++level;
  }
  return level;
}

cv::Mat_<cv::Vec3b> resized_picture(const cv::Mat& image, cv::Size size) {
  cv::Mat_<cv::Vec3b> picture;
  cv::resize(as_picture(image), picture, size, 0, 0, cv::INTER_AREA);
  return picture;
}

ValuePicture encoded_values(const cv::Mat_<float>& values, std::array<double, 2> range) {
  return {encode_webp(draw_values(values, range), kValueQuality), range};
}

FramePictures draw_frame(const vo::RgbdFrame& frame, const vo::PyramidLevel& level,
                         const vo::EdgePointLevel& points, const vo::TrackingResult& result) {
  FramePictures pictures;
  pictures.timestamp = result.timestamp;
  pictures.size = level.intensity.size();
  pictures.colour = encode_webp(resized_picture(frame.image, pictures.size), kColourQuality);
  pictures.edges = edge_overlay(level.edges);
  if (!level.depth.empty()) {
    const auto [nearest, farthest] = positive_range(level.depth);
    pictures.depth = encoded_values(level.depth, {farthest, nearest});
  }
  if (points.size() > 0) {
    pictures.residual_before = encode_residuals(points, level, result.T_cur_ref_guess);
    pictures.residual_after = encode_residuals(points, level, result.alignment.T_cur_ref);
  }
  return pictures;
}

}  // namespace tools
