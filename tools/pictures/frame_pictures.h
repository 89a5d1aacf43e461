#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/tracking/tracking_result.h"

namespace tools {

/// A WebP file and the range of values that its colours span.
struct ValuePicture {
  std::string webp;
  std::array<double, 2> range{};  ///< values shown darkest and brightest
};

/// Pictures of one frame as WebP files of equal size; empty where there is nothing to show.
struct FramePictures {
  double timestamp = 0;  ///< s
  cv::Size size;         ///< px
  std::string colour;
  std::string edges;            ///< edge pixels on a transparent background
  std::string residual_before;  ///< residuals of the first reference's points at the initial pose
  std::string residual_after;
  ValuePicture depth;                ///< depth; range in m, far to near
  ValuePicture inverse_depth;        ///< estimated inverse depth; range in 1/m
  ValuePicture inverse_depth_truth;  ///< true inverse depth in the range of inverse_depth

  std::size_t bytes() const;
};

/// Returns the index of the finest level that is at most so wide, px, or else of the coarsest.
std::size_t level_that_fits(const vo::FramePyramid& pyramid, int max_width);

/// Returns a grey or colour image as a colour picture (BGR) of that size.
cv::Mat_<cv::Vec3b> resized_picture(const cv::Mat& image, cv::Size size);

/// Returns the values in viridis' colours, those of 0 grey; the range may fall.
ValuePicture encoded_values(const cv::Mat_<float>& values, std::array<double, 2> range);

/// Returns the pictures of a tracked frame at one level of its pyramid; `points` are those of the
/// first reference at this level, none where the frame was not aligned.
FramePictures draw_frame(const vo::RgbdFrame& frame, const vo::PyramidLevel& level,
                         const vo::EdgePointLevel& points, const vo::TrackingResult& result);

}  // namespace tools
